//! Text packed for a link: deflated (zlib, RFC 1950, whose checksum finds a link that was cut or
//! changed) and written in the URL-safe alphabet of Base64 (RFC 4648, section 5) without padding.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_zlib_with_limit};

use crate::base::language::tr;

/// Level of deflation: the best one, texts are short.
const LEVEL: u8 = 10;

/// The text, packed.
#[must_use]
pub fn pack(text: &str) -> String {
    URL_SAFE_NO_PAD.encode(compress_to_vec_zlib(text.as_bytes(), LEVEL))
}

/// The text again; at most `most_bytes` of it are ever held.
///
/// # Errors
/// What is wrong: another alphabet, a link that is not whole, text that is too long or not UTF-8.
pub fn unpack(packed: &str, most_bytes: usize) -> Result<String, String> {
    let bytes = URL_SAFE_NO_PAD.decode(packed).map_err(|error| {
        tr!("its packed part is not URL-safe Base64: {problem}", problem = error.to_string())
    })?;
    let text = decompress_to_vec_zlib_with_limit(&bytes, most_bytes).map_err(|error| {
        if error.status == TINFLStatus::HasMoreOutput {
            tr!(
                "its packed part unpacks to more than {n} bytes, the most that are read",
                n = most_bytes
            )
        } else {
            tr("its packed part is not whole").to_owned()
        }
    })?;
    String::from_utf8(text).map_err(|_| tr("text that is not UTF-8").to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_is_unpacked() {
        for text in ["", "a", "Fräsen & Fühlen\n", &"target.ra_um=0.6&".repeat(500)] {
            let packed = pack(text);
            assert!(packed.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_".contains(&b)));
            assert_eq!(unpack(&packed, text.len()).as_deref(), Ok(text));
        }
    }

    #[test]
    fn a_bomb_is_refused_before_it_is_held() {
        let bomb = pack(&"0".repeat(50_000_000));
        assert!(bomb.len() < 100_000);
        let error = unpack(&bomb, 2_000_000).unwrap_err();
        assert!(error.contains("more than 2000000 bytes"), "{error}");
        // One byte too many is too many.
        assert!(unpack(&pack("1234"), 3).is_err());
    }

    #[test]
    fn what_is_cut_or_changed_is_refused() {
        let packed = pack("target.ra_um=0.6&program.feed_mm_min=430.41&run.duration_s=60");
        for cut in [1, 2, 5, packed.len() / 2] {
            assert!(unpack(&packed[..packed.len() - cut], 1000).is_err(), "{cut}");
        }
        let changed = packed.replacen(|c: char| c.is_ascii_lowercase(), "Q", 3);
        assert!(unpack(&changed, 1000).is_err());
        assert!(unpack("a+b", 1000).unwrap_err().contains("Base64"));
    }
}
