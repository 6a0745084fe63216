// Two balls of radius 1 at distance 1, by the declarations for Rust: each loses a cap of height 1/2.
use hardsphere::*;
use std::ptr::{null, null_mut};

include!(concat!(env!("HSP_LAYOUTS")));

fn main() {
    check_layouts();
    let (xyz, radius) = ([0.0, 0.0, 0.0, 1.0, 0.0, 0.0], [1.0, 1.0]);
    let mut area = [0.0; 2];
    let mut totals = hsp_totals { area: 0.0, volume: 0.0, reserved: [0; 2] };
    unsafe {
        let mut bytes = 0;
        assert_eq!(hsp_areas_bytes(2, &mut bytes), HSP_OK);
        let mut memory = vec![0u8; bytes];
        let status = hsp_areas(2, xyz.as_ptr(), radius.as_ptr(), 0.0, memory.as_mut_ptr().cast(), &mut bytes,
                               &mut totals, area.as_mut_ptr());
        assert_eq!(status, HSP_OK);
        assert_eq!(hsp_areas_bytes(2, null_mut()), HSP_E_ARGUMENT);
        assert_eq!(hsp_areas(2, null(), radius.as_ptr(), 0.0, null_mut(), &mut bytes, null_mut(), null_mut()), HSP_E_ARGUMENT);
        let text = std::ffi::CStr::from_ptr(hsp_status_text(HSP_E_ARGUMENT));
        assert!(!text.to_bytes().is_empty());
    }
    println!("{:.6} {:.6}", totals.area, area[1]);
}
