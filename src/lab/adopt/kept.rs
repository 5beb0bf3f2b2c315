//! The laws that were tried on the way to an adoption, in a file: opened by one program at a time and gone on with
//! from its last whole line.

use crate::fingerprint::Fingerprinter;
use crate::lab::campaign::kept::KeptFault;
use crate::lab::fit::memory::TriedLaw;
use crate::study::result::Revisions;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Name of the file.
pub(super) const NAME: &str = "laws.txt";
/// How it begins.
const BEGINS: &str = "meshcast adopt: laws tried for ";

/// The file, open to be written at its end, and what stands in it.
pub(super) struct KeptLaws {
    path: PathBuf,
    file: File,
    known: Vec<TriedLaw>,
}

impl KeptLaws {
    /// Opens the file in a folder, new or, where `resume` says so, to be gone on with; its second part is what to
    /// say where it does not. `print` is all that the laws depend on but for this program.
    ///
    /// # Errors
    /// A file that is in the way, of other data or another program's, or that cannot be written.
    pub(super) fn open(
        folder: &Path,
        print: &str,
        (resume, advice): (bool, &str),
    ) -> Result<KeptLaws, KeptFault> {
        let path = folder.join(NAME);
        let failed = |what: &str, e: &io::Error| {
            KeptFault::Failed(format!("{} {what}: {e}", path.display()))
        };
        std::fs::create_dir_all(folder)
            .map_err(|e| KeptFault::Failed(format!("{} cannot be made: {e}", folder.display())))?;
        let mut file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path)
            .map_err(|e| failed("cannot be opened", &e))?;
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            let said = format!("{}: another meshcast is adopting here", path.display());
            return Err(KeptFault::Asked(said));
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(|e| failed("cannot be read", &e))?;
        if !bytes.is_empty() && !resume {
            let said = format!("{} is there already; {advice}", path.display());
            return Err(KeptFault::Asked(said));
        }
        let print = Fingerprinter::new("adopt").text(print).finish();
        let head = format!("{BEGINS}{print}, revisions {}\n", Revisions::CURRENT);
        let (known, whole) = read(&bytes, &head)
            .map_err(|why| KeptFault::Asked(format!("{}: {why}", path.display())))?;
        let ready = file.set_len(whole as u64).and_then(|()| file.seek(SeekFrom::End(0)));
        ready
            .and_then(|_| if whole == 0 { file.write_all(head.as_bytes()) } else { Ok(()) })
            .map_err(|e| failed("cannot be written", &e))?;
        Ok(KeptLaws { path, file, known })
    }

    /// What stands in it; it can be taken once.
    pub(super) fn take_known(&mut self) -> Vec<TriedLaw> {
        std::mem::take(&mut self.known)
    }

    /// Writes a law behind the others.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(super) fn write(&mut self, tried: &TriedLaw) -> Result<(), KeptFault> {
        self.file.write_all(tried.line().as_bytes()).map_err(|e| {
            KeptFault::Failed(format!("{} cannot be written: {e}", self.path.display()))
        })
    }
}

/// The laws of a file and the bytes up to the end of its last whole line, the head included.
///
/// # Errors
/// What it is instead.
fn read(bytes: &[u8], head: &str) -> Result<(Vec<TriedLaw>, usize), String> {
    // Only a tail can be torn, and the head is plain letters.
    if head.as_bytes().starts_with(bytes) && bytes.len() < head.len() {
        return Ok((Vec::new(), 0));
    }
    let Some(rest) = bytes.strip_prefix(head.as_bytes()) else {
        return Err(if bytes.starts_with(BEGINS.as_bytes()) {
            "it was begun with other values or by another version; remove its folder to begin anew"
        } else {
            "this is no file of an adoption"
        }
        .into());
    };
    let (mut known, mut whole) = (Vec::new(), head.len());
    for line in rest.split_inclusive(|byte| *byte == b'\n') {
        match std::str::from_utf8(line).ok().and_then(TriedLaw::read) {
            Some(tried) => known.push(tried),
            None => break,
        }
        whole += line.len();
    }
    Ok((known, whole))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_goes_on_from_its_last_whole_line_and_only_with_the_same_data() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(NAME);
        let open = |print: &str, resume| KeptLaws::open(folder.path(), print, (resume, "say so"));
        let line = "1 0.4 0.14 0.67 0.16 0.03 0 : 73300 0.6\n";
        let tried = TriedLaw::read(line).unwrap();
        let mut kept = open("a", false).map_err(KeptFault::into_text).unwrap();
        for _ in 0..3 {
            kept.write(&tried).unwrap();
        }
        // Another program waits for this one.
        assert!(open("a", true).err().unwrap().into_text().contains("another meshcast"));
        drop(kept);
        let whole = std::fs::read(&path).unwrap();
        let head = whole.len() - 3 * line.len();
        for (cut, lines) in [(0, 0), (5, 0), (head, 0), (head + 7, 0), (whole.len() - 1, 2)] {
            std::fs::write(&path, &whole[..cut]).unwrap();
            let mut kept = open("a", true).map_err(KeptFault::into_text).unwrap();
            assert_eq!(kept.take_known().len(), lines, "cut at {cut}");
            for _ in lines..3 {
                kept.write(&tried).unwrap();
            }
            drop(kept);
            assert!(std::fs::read(&path).unwrap() == whole, "cut at {cut}");
        }
        let why = |print, resume| open(print, resume).err().unwrap().into_text();
        assert!(why("a", false).contains("say so"));
        assert!(why("b", true).contains("begun with other values"));
        std::fs::write(&path, "my own notes").unwrap();
        assert!(why("a", true).contains("no file of an adoption"));
        assert_eq!(std::fs::read(&path).unwrap(), b"my own notes");
    }
}
