//! A command of this program in a process of its own: a driver that crashes or hangs takes one part of a report with
//! it, and not the report.

use std::{
    io::Read,
    process::{Child, Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use crate::{failure::Failure, interrupt::Interrupt};

/// How a command ended.
pub struct Ended {
    /// What it printed.
    pub stdout: String,
    /// Why it did not end well; nothing if it did.
    pub trouble: Option<String>,
}

/// Runs `brooklet` with `arguments` for `most_s` seconds at most.
///
/// # Errors
/// [`Failure::Interrupted`] on Ctrl-C, [`Failure::Stopped`] if no process can be started.
pub fn run(arguments: &[String], most_s: f64, interrupt: &Interrupt) -> Result<Ended, Failure> {
    let program = std::env::current_exe().map_err(Failure::stopped)?;
    let started = Command::new(program)
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let mut child = started.map_err(|error| Failure::stopped(format_args!("no process can be started: {error}")))?;
    // Both pipes are emptied while it runs: a full one would stop it.
    let stdout = reader(child.stdout.take());
    let stderr = reader(child.stderr.take());
    let end = wait(&mut child, most_s, interrupt);
    let stdout = stdout.join().unwrap_or_default();
    let stderr = stderr.join().unwrap_or_default();
    let trouble = match end {
        End::Exited(None) => None,
        End::Exited(Some(how)) => Some(match last_line(&stderr) {
            Some(line) => format!("{line} ({how})"),
            None => how,
        }),
        End::TooLong => Some(format!("stopped after its {most_s:.0} s")),
        End::Interrupted => return Err(Failure::Interrupted("what was done is kept".into())),
    };
    Ok(Ended { stdout, trouble })
}

enum End {
    Exited(Option<String>),
    TooLong,
    Interrupted,
}

fn wait(child: &mut Child, most_s: f64, interrupt: &Interrupt) -> End {
    let begun = Instant::now();
    let kill = |child: &mut Child| {
        // One that is gone already is what is wanted.
        let _ = child.kill();
        let _ = child.wait();
    };
    loop {
        match child.try_wait() {
            Ok(Some(status)) if status.success() => return End::Exited(None),
            Ok(Some(status)) => return End::Exited(Some(status.to_string())),
            Ok(None) => {}
            Err(error) => {
                kill(child);
                return End::Exited(Some(error.to_string()));
            }
        }
        if interrupt.is_pressed() {
            kill(child);
            return End::Interrupted;
        }
        if begun.elapsed().as_secs_f64() > most_s {
            kill(child);
            return End::TooLong;
        }
        thread::sleep(Duration::from_millis(50));
    }
}

fn reader(pipe: Option<impl Read + Send + 'static>) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // What came before a pipe broke is what there is.
            let _ = pipe.read_to_end(&mut bytes);
        }
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

fn last_line(text: &str) -> Option<&str> {
    text.lines().rev().map(str::trim).find(|line| !line.is_empty())
}
