// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Abut
{
    public partial struct Camera
    {
        /// <summary>A camera of so many pixels at the origin, with the defaults of the library.</summary>
        public Camera(uint width, uint height)
        {
            Native.abut_camera_init(out this, (uint)Marshal.SizeOf(typeof(Camera)));
            Width = width;
            Height = height;
        }

        /// <summary>Turns it so that it looks from one point to another.</summary>
        public void LookAt(Vector eye, Vector target, Vector up)
        {
            Native.Check(Native.abut_camera_look_at(ref this, ref eye, ref target, ref up));
        }
    }

    /// <summary>Rays and the mouse against one universe, which it follows and keeps alive. It needs libabut_picking.</summary>
    public sealed class Picker : SafeHandle
    {
        private readonly Universe universe;

        public Picker(Universe universe) : base(IntPtr.Zero, true)
        {
            Native.Check(Native.abut_picker_create(universe, out IntPtr picker));
            // The universe must not go before the picker, in whatever order both are collected.
            bool isHeld = false;
            universe.DangerousAddRef(ref isHeld);
            this.universe = universe;
            SetHandle(picker);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.abut_picker_destroy(handle);
            universe.DangerousRelease();
            return true;
        }

        /// <summary>The first thing that a ray meets; null for none. It sees poses as they are set.</summary>
        public Hit? CastRay(Vector origin, Vector direction, double maxDistance = double.PositiveInfinity)
        {
            var ray = new Ray { Origin = origin, Direction = direction, MaxDistance = maxDistance };
            Native.Check(Native.abut_picker_cast_ray(this, ref ray, null, out Hit hit));
            return Found(hit);
        }

        /// <summary>Every crossing of a surface, nearest first.</summary>
        public Hit[] CastRayAll(Vector origin, Vector direction, double maxDistance = double.PositiveInfinity)
        {
            var ray = new Ray { Origin = origin, Direction = direction, MaxDistance = maxDistance };
            return Native.Filled<Hit>(8, (Hit[] hits, UIntPtr capacity, out UIntPtr count) =>
                Native.abut_picker_cast_ray_all(this, ref ray, null, hits, capacity, out count));
        }

        /// <summary>What lies under a point of the picture, or within a radius of it; null for nothing.</summary>
        public Hit? PickPixel(Camera camera, double x, double y, double radius = 0)
        {
            Native.Check(Native.abut_picker_pick_pixel(this, ref camera, x, y, radius, null, out Hit hit));
            return Found(hit);
        }

        /// <summary>Chooses whether queries meet sensors, and surfaces whose normal points along the ray.</summary>
        public void SetFlags(PickerFlags flags) => Native.Check(Native.abut_picker_set_flags(this, flags));

        /// <summary>Geometries in the rectangle with the corners (x0, y0) and (x1, y1).</summary>
        public GeometryId[] Select(
            Camera camera, double x0, double y0, double x1, double y1, Selection selection = Selection.Touching)
        {
            return Native.Filled<GeometryId>(64, (GeometryId[] place, UIntPtr capacity, out UIntPtr count) =>
                Native.abut_picker_select_rectangle(
                    this, ref camera, x0, y0, x1, y1, selection, null, place, capacity, out count));
        }

        /// <summary>One ray through the centre of each pixel, row by row from the top. Where nothing is met the slot of the
        /// geometry is 0.</summary>
        public Hit[] Render(Camera camera)
        {
            var hits = new Hit[checked((int)(camera.Width * camera.Height))];
            Native.Check(Native.abut_picker_render(this, ref camera, null, hits, (UIntPtr)(uint)hits.Length));
            return hits;
        }

        private static Hit? Found(Hit hit) => hit.Geometry.Slot != 0 ? hit : (Hit?)null;
    }
}
