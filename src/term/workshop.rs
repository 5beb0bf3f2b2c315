//! Work behind the screen: a desk whose news go to the loop.

use super::events::Mail;
use crate::app::message::Message;
use crate::job::news::What;
use crate::job::{Desk, News, Order};
use std::thread;

/// The worker, if the system gave one.
#[derive(Debug)]
pub(super) struct Workshop {
    desk: Option<Desk<Order>>,
}

impl Workshop {
    /// Starts the worker.
    pub(super) fn open(mail: Mail) -> Workshop {
        let failed = mail.clone();
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let desk = Desk::open(
            move |order: &Order, ticket| {
                // Where nobody reads any more, the program is about to end.
                order.carry_out(threads, ticket, &|news| {
                    mail.send(Message::Work(news));
                });
            },
            move |order| {
                failed.send(Message::Work(News { number: order.number, what: What::Failed }));
            },
        );
        Workshop { desk }
    }

    /// No worker at all.
    #[cfg(test)]
    pub(super) fn none() -> Workshop {
        Workshop { desk: None }
    }

    /// Hands in an order; what to tell of one that will not be done.
    pub(super) fn order(&self, order: Order) -> Vec<Message> {
        match &self.desk {
            Some(desk) => never_begun(desk.submit(order.urgency(), order)),
            None => vec![
                Message::Work(News { number: order.number, what: What::Failed }),
                Message::Trouble("the system gives no thread to check with".into()),
            ],
        }
    }

    /// Ends what runs; what to tell of what waited.
    pub(super) fn stop(&self) -> Vec<Message> {
        self.desk.as_ref().map_or_else(Vec::new, |desk| never_begun(desk.cancel()))
    }
}

/// The end of an order that never began: the state waits for it as for any other.
fn never_begun(order: Option<Order>) -> Vec<Message> {
    let ended = |order: Order| {
        Message::Work(News { number: order.number, what: What::Ended { cancelled: true } })
    };
    order.map(ended).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::super::events;
    use super::*;
    use crate::dem::Fidelity;
    use crate::job::checks::Checks;
    use crate::job::order::Task;
    use crate::study::result::Wanted;

    fn ends(messages: &[Message]) -> Vec<(u64, bool)> {
        let end = |message: &Message| match message {
            Message::Work(News { number, what: What::Ended { cancelled } }) => {
                (*number, *cancelled)
            }
            other => panic!("{other:?}"),
        };
        messages.iter().map(end).collect()
    }

    /// The state takes an order as running until it hears of its end.
    #[test]
    fn each_order_has_one_end_also_one_that_never_began() {
        let (mail, events) = events::open();
        let workshop = Workshop::open(mail);
        let wanted = Wanted { fidelity: Fidelity::Quick.into(), runs: Some(1), seed: 0 };
        let empty = |number: u64| Order {
            number,
            task: Task::Checks(Checks { targets: vec![], wanted: wanted.clone(), live: false }),
        };
        let mut ended: Vec<(u64, bool)> = Vec::new();
        for number in 1..=200 {
            ended.extend(ends(&workshop.order(empty(number))));
            if number % 3 == 0 {
                ended.extend(ends(&workshop.stop()));
            }
        }
        while ended.len() < 200 {
            let event = events.recv_timeout(std::time::Duration::from_secs(20)).unwrap();
            let events::Event::Message(message) = event else { panic!("{event:?}") };
            ended.extend(ends(&[message]));
        }
        let mut numbers: Vec<u64> = ended.iter().map(|(number, _)| *number).collect();
        numbers.sort_unstable();
        assert_eq!(numbers, (1..=200).collect::<Vec<_>>());
    }
}
