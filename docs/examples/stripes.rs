use std::ffi::{c_char, c_int, c_void, CStr};
use std::ptr::{null, null_mut};

#[repr(C)]
#[derive(Clone, Copy)]
struct Array {
    data: *const c_void,
    rows: usize,
    columns: usize,
    row_stride: isize,
    column_stride: isize,
    number: c_int,
}

type Handle = *mut c_void;

#[link(name = "brindle_c")]
extern "C" {
    fn brindle_error() -> *const c_char;
    fn brindle_make_surface(p: Array, t: Array, o: *const c_void, report: *const c_void, out: *mut Handle) -> c_int;
    fn brindle_make_smooth_field(s: Handle, o: *const c_void, report: *const c_void, out: *mut Handle) -> c_int;
    fn brindle_make_stripes(s: Handle, f: Handle, q: Array, o: *const c_void, report: *const c_void, out: *mut Handle) -> c_int;
    fn brindle_get_pattern_array(p: Handle, which: c_int, out: *mut Array) -> c_int;
}

fn table<T>(numbers: &[T], columns: usize, number: c_int) -> Array {
    Array { data: numbers.as_ptr().cast(), rows: numbers.len() / columns, columns, row_stride: 0, column_stride: 0, number }
}

fn check(status: c_int) {
    assert!(status == 0, "{}", unsafe { CStr::from_ptr(brindle_error()) }.to_string_lossy());
}

fn main() {
    let points = [0.0f64, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.2, 0.0, 1.0, 0.0];
    let (mut surface, mut field, mut pattern): (Handle, Handle, Handle) = (null_mut(), null_mut(), null_mut());
    let mut phases = table::<f32>(&[], 2, 0);
    unsafe {
        check(brindle_make_surface(table(&points, 3, 1), table(&[0i32, 1, 2, 0, 2, 3], 3, 6), null(), null(), &mut surface));
        check(brindle_make_smooth_field(surface, null(), null(), &mut field));
        check(brindle_make_stripes(surface, field, table(&[3.0f32], 1, 0), null(), null(), &mut pattern));
        check(brindle_get_pattern_array(pattern, 0, &mut phases));
        for z in std::slice::from_raw_parts(phases.data.cast::<[f32; 2]>(), phases.rows) {
            println!("{:.6} {:.6}", z[0], z[1]);
        }
    } // the process ends: handles need not be freed
}
