//! Snappy, Google's compression, as its description of the format has it: pieces as they are, and copies of what came
//! before.

/// The bytes that packed ones stand for; none if they are spoilt, or not `size` bytes.
pub(super) fn unpacked(packed: &[u8], size: usize) -> Option<Vec<u8>> {
    let (told, mut rest) = length(packed)?;
    // A copy of three bytes gives 64 at most.
    if told != size || size > packed.len().saturating_mul(64) {
        return None;
    }
    let mut found: Vec<u8> = Vec::with_capacity(size);
    while let Some((tag, behind)) = rest.split_first() {
        let upper = usize::from(tag >> 2);
        match tag & 3 {
            0 => {
                // Lengths above 60 stand in bytes of their own.
                let bytes = upper.saturating_sub(59);
                let count = if bytes == 0 { upper } else { little(behind.get(..bytes)?) } + 1;
                let piece = behind.get(bytes..bytes.checked_add(count)?)?;
                found.extend(piece);
                rest = &behind[bytes + count..];
            }
            1 => {
                let offset = usize::from(tag >> 5) << 8 | usize::from(*behind.first()?);
                copy(&mut found, offset, (upper & 7) + 4, size)?;
                rest = &behind[1..];
            }
            kind => {
                let bytes = if kind == 2 { 2 } else { 4 };
                copy(&mut found, little(behind.get(..bytes)?), upper + 1, size)?;
                rest = &behind[bytes..];
            }
        }
        if found.len() > size {
            return None;
        }
    }
    (found.len() == size).then_some(found)
}

/// A number of bytes, the lowest first.
fn little(bytes: &[u8]) -> usize {
    bytes.iter().rev().fold(0, |number, byte| number << 8 | usize::from(*byte))
}

/// The length at the start: seven bits in a byte, the lowest first.
fn length(packed: &[u8]) -> Option<(usize, &[u8])> {
    let mut number = 0;
    for (place, byte) in packed.iter().enumerate().take(5) {
        number |= u64::from(byte & 0x7f) << (7 * place);
        if byte & 0x80 == 0 {
            return Some((usize::try_from(number).ok()?, &packed[place + 1..]));
        }
    }
    None
}

/// Repeats what stands `offset` bytes before; more than that repeats what it has just written.
fn copy(found: &mut Vec<u8>, offset: usize, count: usize, size: usize) -> Option<()> {
    let from =
        found.len().checked_sub(offset).filter(|_| offset > 0 && found.len() + count <= size)?;
    for at in from..from + count {
        let byte = found[at];
        found.push(byte);
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_and_copies_are_put_together() {
        // A piece of four, a copy of six that runs into itself, one by two bytes of offset, a long piece.
        let mut packed = vec![80];
        packed.extend([3 << 2, b'a', b'b', b'c', b'd']);
        packed.extend([1 | 2 << 2, 2]);
        packed.extend([2 | 4 << 2, 10, 0]);
        packed.extend([60 << 2, 64]);
        packed.extend([b'x'; 65]);
        let expected = format!("abcdcdcdcdabcdc{}", "x".repeat(65));
        assert_eq!(unpacked(&packed, 80).as_deref(), Some(expected.as_bytes()));
        assert_eq!(unpacked(&packed, 81), None);
        for end in 0..packed.len() {
            assert_eq!(unpacked(&packed[..end], 80), None, "{end}");
        }
        // A copy of what is not there, one of no distance, a length without end.
        for spoilt in [&[4, 1, 9][..], &[4, 0, b'a', 1, 0], &[0xff, 0xff, 0xff, 0xff, 0xff, 1]] {
            assert_eq!(unpacked(spoilt, 4), None);
        }
    }
}
