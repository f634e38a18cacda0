// SPDX-License-Identifier: Apache-2.0
//! Failures: the status of the C interface and the sentence that comes with it.

use crate::raw;
use std::ffi::CStr;
use std::fmt;

/// What went wrong; abut.h describes each.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Status {
    /// A value outside its domain that has no status of its own.
    InvalidArgument,
    /// A pointer that must not be null.
    NullArgument,
    /// A NaN or an infinity.
    NotFinite,
    /// A number that is negative, zero or too large where it must not be.
    OutOfRange,
    /// A normal, direction or quaternion without length.
    ZeroVector,
    /// A quaternion whose length is off 1 by more than 1e-3.
    NotUnit,
    /// An index past the end of what it points into.
    IndexOutOfRange,
    /// More elements than fit into memory.
    SizeOverflow,
    /// A mesh, hull or field with nothing in it.
    Empty,
    /// An id that is null, destroyed, or of another universe.
    StaleId,
    /// A struct of a size that the library does not know.
    WrongStructSize,
    /// An enumeration value, kind, flag or name that does not exist.
    UnknownValue,
    /// A shape, feature, pair or algorithm that is not available.
    Unsupported,
    /// An algorithm of another library gave up or returned nonsense.
    NotConverged,
    /// Nothing has changed, but a universe in a detection answers `Internal` from now on.
    OutOfMemory,
    /// A defect of abut.
    Internal,
    /// A call that changes a universe from a filter of it.
    Busy,
    /// A status that this version of the crate does not know.
    Other(i32),
}

impl Status {
    fn from_raw(status: raw::abut_status) -> Status {
        match status {
            raw::ABUT_INVALID_ARGUMENT => Status::InvalidArgument,
            raw::ABUT_NULL_ARGUMENT => Status::NullArgument,
            raw::ABUT_NOT_FINITE => Status::NotFinite,
            raw::ABUT_OUT_OF_RANGE => Status::OutOfRange,
            raw::ABUT_ZERO_VECTOR => Status::ZeroVector,
            raw::ABUT_NOT_UNIT => Status::NotUnit,
            raw::ABUT_INDEX_OUT_OF_RANGE => Status::IndexOutOfRange,
            raw::ABUT_SIZE_OVERFLOW => Status::SizeOverflow,
            raw::ABUT_EMPTY => Status::Empty,
            raw::ABUT_STALE_ID => Status::StaleId,
            raw::ABUT_WRONG_STRUCT_SIZE => Status::WrongStructSize,
            raw::ABUT_UNKNOWN_VALUE => Status::UnknownValue,
            raw::ABUT_UNSUPPORTED => Status::Unsupported,
            raw::ABUT_NOT_CONVERGED => Status::NotConverged,
            raw::ABUT_OUT_OF_MEMORY => Status::OutOfMemory,
            raw::ABUT_INTERNAL => Status::Internal,
            raw::ABUT_BUSY => Status::Busy,
            _ => Status::Other(status),
        }
    }
}

/// A call that failed. Nothing has changed then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    status: Status,
    message: String,
}

/// What calls that can fail return.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// What went wrong, for programs.
    pub fn status(&self) -> Status {
        self.status
    }

    /// Which argument, which value and what was expected, for people.
    pub fn message(&self) -> &str {
        &self.message
    }

    pub(crate) fn invalid(message: String) -> Error {
        Error { status: Status::InvalidArgument, message }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

/// The failure that a status stands for. The message belongs to this thread and this moment, so it is copied.
pub(crate) fn check(status: raw::abut_status) -> Result<()> {
    if status == raw::ABUT_OK {
        return Ok(());
    }
    // SAFETY: the message is never null, is terminated, and stays until the next call on this thread.
    let message = unsafe { CStr::from_ptr(raw::abut_last_error_message()) };
    Err(Error { status: Status::from_raw(status), message: message.to_string_lossy().into_owned() })
}

/// Refuses two slices of different lengths, of which the interface takes only one count.
pub(crate) fn expect_as_many(first: (&str, usize), second: (&str, usize)) -> Result<()> {
    if first.1 == second.1 {
        return Ok(());
    }
    Err(Error::invalid(format!(
        "{} has {} elements and {} has {}; expected as many",
        first.0, first.1, second.0, second.1
    )))
}
