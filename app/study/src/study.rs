//! Which tasks a study has.

use crate::error::{self, Choice};
use crate::session::StudyError;
use crate::{Task, precision, stability, validation};

/// A study: which parts, and of the first which curves.
#[derive(Clone, Debug)]
pub struct Study {
    /// Work-precision, orders, and how iterations are spent best; which curves.
    pub error: Option<Choice>,
    /// Published cases.
    pub validation: bool,
    /// Lower precision and smaller tiers.
    pub precision: bool,
    /// Extreme cases and maps.
    pub stability: bool,
    /// Few of everything, within minutes.
    pub quick: bool,
}

impl Study {
    /// Everything it runs, in order.
    ///
    /// # Errors
    /// If a chosen name is not there.
    pub fn tasks(&self) -> Result<Vec<Task>, StudyError> {
        let mut tasks = Vec::new();
        if self.validation {
            tasks.extend(validation::tasks(self.quick).into_iter().map(|(_, task)| task));
        }
        if let Some(choice) = &self.error {
            tasks.extend(error::tasks(choice)?);
            // What is asked for by name is all that is wanted.
            if choice.is_whole() {
                tasks.extend(error::order_tasks(self.quick).into_iter().map(|(_, task)| task));
                tasks.extend(error::jacobi_tasks());
                tasks.extend(error::overhead_tasks(self.quick));
                if !self.quick {
                    tasks.extend(error::equal_work_tasks());
                }
            }
        }
        if self.precision {
            tasks.extend(precision::tasks(self.quick));
        }
        if self.stability {
            tasks.extend(stability::row_tasks(self.quick));
            tasks.extend(stability::map_tasks(self.quick));
        }
        Ok(tasks)
    }
}

/// Every `of`-th task from the `index`-th, from 1: a part for one machine of several.
pub fn shard(tasks: Vec<Task>, index: usize, of: usize) -> Vec<Task> {
    tasks.into_iter().skip(index.saturating_sub(1)).step_by(of.max(1)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn study(quick: bool) -> Study {
        let choice = Choice { cases: Vec::new(), methods: Vec::new(), knobs: Vec::new(), quick };
        Study { error: Some(choice), validation: true, precision: true, stability: true, quick }
    }

    #[test]
    fn shards_are_all_tasks_and_each_once() {
        let all = study(false).tasks().unwrap();
        let mut joined: Vec<Task> = (1..=3).flat_map(|index| shard(all.clone(), index, 3)).collect();
        assert_eq!(joined.len(), all.len());
        joined.retain(|task| !all.contains(task));
        assert!(joined.is_empty());
    }

    #[test]
    fn no_task_is_there_twice() {
        for quick in [false, true] {
            let all = study(quick).tasks().unwrap();
            let mut keys: Vec<String> = all.iter().map(|task| task.key("")).collect();
            keys.sort_unstable();
            keys.dedup();
            assert_eq!(keys.len(), all.len());
        }
    }
}
