//! A campaign of checks behind the screen: the cases of a study, one after the other, each told as soon
//! as it is done.

use super::desk::Ticket;
use super::news::{Progress, What};
use super::pace::{Pace, QUIET};
use crate::case::Case;
use crate::dem::Flow;
use crate::study::checks::{self, NoCheck, checks};
use crate::study::result::Wanted;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Cases to be checked, all asked for alike, so that they share alignments and slack.
#[derive(Debug, Clone)]
pub struct Campaign {
    /// What to check, in this order.
    pub cases: Vec<Case>,
    /// How.
    pub wanted: Wanted,
}

/// How far the campaign is.
struct Seen {
    pace: Pace,
    /// The case that speaks.
    index: Option<usize>,
    spoke: Instant,
}

impl Campaign {
    /// Checks the cases, until the ticket says to end.
    pub(super) fn carry_out(&self, threads: usize, ticket: &Ticket, say: &(dyn Fn(What) + Sync)) {
        if ticket.cancelled() {
            return;
        }
        let start = Instant::now();
        let seen = Mutex::new(Seen { pace: Pace::default(), index: None, spoke: start });
        let listen = |news: checks::CaseNews| {
            match news.what {
                checks::CaseEvent::Progress(now) => {
                    // Nothing that holds the lock can panic halfway.
                    let mut seen = seen.lock().unwrap_or_else(PoisonError::into_inner);
                    if seen.index != Some(news.index) {
                        let end = self.cases.get(news.index).map_or(0.0, Case::expected_break)
                            + self.wanted.controls().after_break;
                        seen.pace.begin(news.index, news.total, end);
                        seen.index = Some(news.index);
                    }
                    seen.pace.take(now.run, now.planned, &now.inner);
                    if seen.spoke.elapsed() >= QUIET {
                        seen.spoke = Instant::now();
                        let progress = Progress {
                            part: news.index,
                            parts: news.total,
                            done: now.done,
                            planned: now.planned,
                            fraction: seen.pace.fraction(),
                            left: seen.pace.left(start.elapsed().as_secs_f64()),
                            ..Progress::default()
                        };
                        drop(seen);
                        say(What::Progress(progress));
                    }
                }
                // One that was ended before a run of it was whole is no news.
                checks::CaseEvent::Done(Err(NoCheck::NotMade)) => {}
                checks::CaseEvent::Done(answer) => say(What::Case {
                    index: news.index,
                    total: news.total,
                    answer: Arc::new(answer.clone()),
                }),
            }
            if ticket.cancelled() { Flow::Cancel } else { Flow::Continue }
        };
        checks(&self.cases, &self.wanted, threads, &listen);
    }
}

#[cfg(test)]
mod tests {
    use super::super::order::{Order, Task};
    use super::*;
    use crate::forecast::design::Question;
    use crate::layout::{BranchRule, Layout, REFERENCE};
    use crate::mesh::catalogue;
    use crate::study::exactness::Exactness;

    fn order() -> Order {
        let case = |spacing| Case {
            layout: Layout { spacing, punch: 0.4, ..REFERENCE },
            mesh: catalogue::reference(),
            rule: BranchRule::Published,
            question: Question::default(),
        };
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(2), seed: 0 };
        let cases = vec![case(1.3), case(0.35), case(1.4)];
        Order { number: 5, task: Task::Campaign(Campaign { cases, wanted }) }
    }

    fn heard(ticket: &Ticket, end_after: usize) -> Vec<String> {
        let heard = Mutex::new(Vec::new());
        order().carry_out(2, ticket, &|news| {
            assert_eq!(news.number, 5);
            let said = match news.what {
                What::Case { index, total, answer } => match &*answer {
                    Ok(result) => format!("{index} of {total}: {} runs", result.runs),
                    Err(why) => format!("{index} of {total}: {}", why.code()),
                },
                What::Ended { cancelled } => format!("ended {cancelled}"),
                _ => return,
            };
            let mut heard = heard.lock().unwrap();
            heard.push(said);
            if heard.len() == end_after {
                ticket.cancel();
            }
        });
        heard.into_inner().unwrap()
    }

    #[test]
    fn each_case_is_told_when_it_is_done() {
        let all = heard(&Ticket::default(), usize::MAX);
        assert_eq!(all, ["0 of 3: 2 runs", "1 of 3: impossible", "2 of 3: 2 runs", "ended false"]);
    }

    #[test]
    fn a_campaign_that_is_ended_keeps_what_was_told() {
        assert_eq!(heard(&Ticket::default(), 1), ["0 of 3: 2 runs", "ended true"]);
        let ticket = Ticket::default();
        ticket.cancel();
        assert_eq!(heard(&ticket, usize::MAX), ["ended true"]);
    }
}
