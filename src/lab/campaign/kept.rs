//! A campaign's file on disk: opened by one program at a time, gone on with from its last whole line, and
//! written as the runs are made.

use super::Header;
use super::file::{self, CampaignText};
use super::make::{CampaignEnd, make};
use super::row::Row;
use crate::dem::Flow;
use crate::mesh::wire::WireData;
use crate::study::ensemble::EnsembleProgress;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Why a campaign's file is not opened or written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum KeptFault {
    /// What was asked for does not go with what is there.
    Asked(String),
    /// The disk.
    Failed(String),
}

impl KeptFault {
    /// What is wrong, for people.
    pub(crate) fn into_text(self) -> String {
        match self {
            KeptFault::Asked(said) | KeptFault::Failed(said) => said,
        }
    }
}

/// A campaign's file, open to be written at its end, and what stands in it.
pub(crate) struct Kept {
    path: PathBuf,
    file: File,
    rows: Vec<Row>,
}

impl Kept {
    /// Opens the file in a folder, new or, where `resume` says so, to be gone on with; its second part is
    /// what to say where it does not.
    ///
    /// # Errors
    /// A file that is in the way, of another campaign or another program's, or that cannot be written.
    pub(crate) fn open(
        folder: &Path,
        header: &Header,
        resume: (bool, &str),
    ) -> Result<Kept, KeptFault> {
        let path = folder.join(file::NAME);
        std::fs::create_dir_all(folder)
            .map_err(|e| KeptFault::Failed(format!("{} cannot be made: {e}", folder.display())))?;
        let mut options = OpenOptions::new();
        options.read(true).write(true).create(true);
        let file = options.open(&path);
        let file = file.map_err(|e| refused(&path, "cannot be opened", &e))?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                let said = format!("{}: another meshcast writes this campaign", path.display());
                return Err(KeptFault::Asked(said));
            }
            // A disk that locks nothing is no reason to refuse.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let mut kept = Kept { path, file, rows: Vec::new() };
        kept.go_on(header, resume)?;
        Ok(kept)
    }

    /// The file.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// The lines that stand in it.
    pub(crate) fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Makes the lines that are missing, each written as it comes; ended by `progress`.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(crate) fn make(
        &mut self,
        header: &Header,
        wire: &WireData,
        threads: usize,
        progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
    ) -> Result<CampaignEnd, KeptFault> {
        let from = self.rows.len();
        let mut failed = None;
        let Kept { file, rows, .. } = self;
        let mut hand_on = |row: Row| {
            let written = file.write_all(file::line(&row).as_bytes());
            rows.push(row);
            match written {
                Ok(()) => Flow::Continue,
                Err(e) => {
                    failed = Some(e);
                    Flow::Cancel
                }
            }
        };
        let end = make(&header.plan, wire, from, threads, progress, &mut hand_on);
        let synced = file.sync_all();
        match failed.or(synced.err()) {
            Some(e) => Err(self.fault("cannot be written", &e)),
            None => Ok(end),
        }
    }

    /// The campaign as it stands in the file.
    pub(crate) fn into_text(self, header: Header) -> CampaignText {
        CampaignText { header, rows: self.rows, whole: 0 }
    }

    /// Reads what is there, cuts off a torn line, and stands behind the last whole one.
    fn go_on(&mut self, header: &Header, (resume, advice): (bool, &str)) -> Result<(), KeptFault> {
        let mut text = Vec::new();
        self.file.read_to_end(&mut text).map_err(|e| self.fault("cannot be read", &e))?;
        if !text.is_empty() && !resume {
            return Err(KeptFault::Asked(format!(
                "{} exists already and is not overwritten; {advice}",
                self.path.display()
            )));
        }
        let found = file::read(&text).map_err(|said| self.wrong(&said))?;
        let whole = found.as_ref().map_or(0, |found| found.whole);
        if let Some(CampaignText { header: there, rows, .. }) = found {
            if let Some(said) = there.differs(header) {
                return Err(self.wrong(&format!("it was made otherwise: {said}")));
            }
            if rows.len() > header.plan.lines() {
                return Err(self.wrong("it has more lines than it should"));
            }
            self.rows = rows;
        }
        let cut = self.file.set_len(whole as u64);
        cut.and_then(|()| self.file.seek(SeekFrom::End(0)).map(|_| ()))
            .and_then(|()| if whole == 0 { self.write_header(header) } else { Ok(()) })
            .map_err(|e| self.fault("cannot be written", &e))
    }

    fn write_header(&mut self, header: &Header) -> io::Result<()> {
        self.file.write_all(file::line(header).as_bytes())
    }

    fn wrong(&self, said: &str) -> KeptFault {
        KeptFault::Asked(format!("{}: {said}", self.path.display()))
    }

    fn fault(&self, what: &str, error: &io::Error) -> KeptFault {
        refused(&self.path, what, error)
    }
}

fn refused(path: &Path, what: &str, error: &io::Error) -> KeptFault {
    KeptFault::Failed(format!("{} {what}: {error}", path.display()))
}
