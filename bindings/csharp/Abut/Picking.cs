// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Abut
{
    /// <summary>A pinhole camera that looks along its local -Z, with local +Y up. x runs to the right and y down.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Camera
    {
        private uint structSize;
        public uint Width, Height;
        private readonly uint reserved;
        public Pose Pose;
        /// <summary>Between the upper and the lower edge, in radians.</summary>
        public double VerticalFov;
        public double NearDistance, FarDistance;

        /// <summary>A camera of so many pixels at the origin, with the defaults of the library.</summary>
        public Camera(uint width, uint height)
        {
            PickingNative.abut_camera_init(out this, (uint)Marshal.SizeOf(typeof(Camera)));
            Width = width;
            Height = height;
        }

        /// <summary>Turns it so that it looks from one point to another.</summary>
        public void LookAt(Vector eye, Vector target, Vector up)
        {
            Native.Check(PickingNative.abut_camera_look_at(ref this, ref eye, ref target, ref up));
        }
    }

    /// <summary>Rays and the mouse against one universe, which it follows and keeps alive. It needs libabut_picking.</summary>
    public sealed class Picker : SafeHandle
    {
        private readonly Universe universe;

        public Picker(Universe universe) : base(IntPtr.Zero, true)
        {
            Native.Check(PickingNative.abut_picker_create(universe, out IntPtr picker));
            // The universe must not go before the picker, in whatever order both are collected.
            bool isHeld = false;
            universe.DangerousAddRef(ref isHeld);
            this.universe = universe;
            SetHandle(picker);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            PickingNative.abut_picker_destroy(handle);
            universe.DangerousRelease();
            return true;
        }

        /// <summary>The first thing that a ray meets; null for none. It sees poses as they are set.</summary>
        public Hit? CastRay(Vector origin, Vector direction, double maxDistance = double.PositiveInfinity)
        {
            var ray = new Ray { Origin = origin, Direction = direction, MaxDistance = maxDistance };
            Native.Check(PickingNative.abut_picker_cast_ray(this, ref ray, IntPtr.Zero, out Hit hit));
            return Found(hit);
        }

        /// <summary>Every crossing of a surface, nearest first.</summary>
        public Hit[] CastRayAll(Vector origin, Vector direction, double maxDistance = double.PositiveInfinity)
        {
            var ray = new Ray { Origin = origin, Direction = direction, MaxDistance = maxDistance };
            return Native.Filled<Hit>(8, (Hit[] hits, UIntPtr capacity, out UIntPtr count) =>
                PickingNative.abut_picker_cast_ray_all(this, ref ray, IntPtr.Zero, hits, capacity, out count));
        }

        /// <summary>What lies under a point of the picture, or within a radius of it; null for nothing.</summary>
        public Hit? PickPixel(Camera camera, double x, double y, double radius = 0)
        {
            Native.Check(PickingNative.abut_picker_pick_pixel(this, ref camera, x, y, radius, IntPtr.Zero, out Hit hit));
            return Found(hit);
        }

        /// <summary>One ray through the centre of each pixel, row by row from the top. Where nothing is met the slot of the
        /// geometry is 0.</summary>
        public Hit[] Render(Camera camera)
        {
            var hits = new Hit[checked((int)(camera.Width * camera.Height))];
            Native.Check(PickingNative.abut_picker_render(this, ref camera, IntPtr.Zero, hits, (UIntPtr)(uint)hits.Length));
            return hits;
        }

        private static Hit? Found(Hit hit) => hit.Geometry.Slot != 0 ? hit : (Hit?)null;
    }

    /// <summary>Calls of picking.h, a library of its own: who never picks never loads it.</summary>
    internal static class PickingNative
    {
        private const string Library = "abut_picking";

        [DllImport(Library)] internal static extern void abut_camera_init(out Camera camera, uint size);
        [DllImport(Library)] internal static extern int abut_camera_look_at(
            ref Camera camera, ref Vector eye, ref Vector target, ref Vector up);
        [DllImport(Library)] internal static extern int abut_picker_create(Universe universe, out IntPtr picker);
        [DllImport(Library)] internal static extern void abut_picker_destroy(IntPtr picker);
        [DllImport(Library)] internal static extern int abut_picker_cast_ray(
            Picker picker, ref Ray ray, IntPtr filter, out Hit hit);
        [DllImport(Library)] internal static extern int abut_picker_cast_ray_all(
            Picker picker, ref Ray ray, IntPtr filter, [Out] Hit[] hits, UIntPtr capacity, out UIntPtr count);
        [DllImport(Library)] internal static extern int abut_picker_pick_pixel(
            Picker picker, ref Camera camera, double x, double y, double radius, IntPtr filter, out Hit hit);
        [DllImport(Library)] internal static extern int abut_picker_render(
            Picker picker, ref Camera camera, IntPtr filter, [Out] Hit[] hits, UIntPtr capacity);
    }
}
