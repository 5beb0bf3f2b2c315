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

    /// Hands in an order; what to tell where there is no worker.
    pub(super) fn order(&self, order: Order) -> Vec<Message> {
        match &self.desk {
            Some(desk) => {
                desk.submit(order.urgency(), order);
                Vec::new()
            }
            None => vec![
                Message::Work(News { number: order.number, what: What::Failed }),
                Message::Trouble("the system gives no thread to check with".into()),
            ],
        }
    }

    /// Ends what runs.
    pub(super) fn stop(&self) {
        if let Some(desk) = &self.desk {
            desk.cancel();
        }
    }
}
