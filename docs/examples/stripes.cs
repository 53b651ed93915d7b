using System;
using System.Globalization;
using System.Runtime.InteropServices;

static class Stripes {
  [StructLayout(LayoutKind.Sequential)]
  struct Table { public IntPtr Data; public UIntPtr Rows, Columns; public IntPtr RowStride, ColumnStride; public int Type; }

  const string Lib = "brindle_c";
  [DllImport(Lib)] static extern IntPtr brindle_error();
  [DllImport(Lib)] static extern int brindle_make_surface(Table p, Table t, IntPtr options, IntPtr progress, out IntPtr surface);
  [DllImport(Lib)] static extern int brindle_make_smooth_field(IntPtr surface, IntPtr options, IntPtr progress, out IntPtr field);
  [DllImport(Lib)] static extern int brindle_make_stripes(IntPtr surface, IntPtr field, Table frequency, IntPtr options, IntPtr progress, out IntPtr pattern);
  [DllImport(Lib)] static extern int brindle_get_pattern_array(IntPtr pattern, int which, out Table array);

  static Table TableOf(Array numbers, int columns, int type) {
    GCHandle pin = GCHandle.Alloc(numbers, GCHandleType.Pinned);  // pinned until the process ends
    return new Table { Data = pin.AddrOfPinnedObject(), Rows = (UIntPtr)(numbers.Length / columns), Columns = (UIntPtr)columns, Type = type };
  }

  static void Check(int status) {
    if (status != 0) throw new Exception(Marshal.PtrToStringAnsi(brindle_error()));
  }

  static void Main() {
    var points = new double[] { 0, 0, 0, 1, 0, 0, 1, 1, 0.2, 0, 1, 0 };
    IntPtr surface, field, pattern;
    Table phases;
    Check(brindle_make_surface(TableOf(points, 3, 1), TableOf(new int[] { 0, 1, 2, 0, 2, 3 }, 3, 6), IntPtr.Zero, IntPtr.Zero, out surface));
    Check(brindle_make_smooth_field(surface, IntPtr.Zero, IntPtr.Zero, out field));
    Check(brindle_make_stripes(surface, field, TableOf(new float[] { 3 }, 1, 0), IntPtr.Zero, IntPtr.Zero, out pattern));
    Check(brindle_get_pattern_array(pattern, 0, out phases));
    var z = new float[2 * (int)phases.Rows];
    Marshal.Copy(phases.Data, z, 0, z.Length);
    for (int i = 0; i < z.Length; i += 2)
      Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0:F6} {1:F6}", z[i], z[i + 1]));
  }
}
