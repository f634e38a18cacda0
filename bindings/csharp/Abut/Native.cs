// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Abut
{
    /// <summary>Calls of the C interface; include/abut/abut.h describes each.</summary>
    internal static partial class Native
    {
        // Another library of 0.x has other structs.
        static Native()
        {
            Check(abut_check_version(Major, Minor));
        }

        /// <summary>Throws what a status stands for. The message belongs to this thread and this moment.</summary>
        internal static void Check(Status status)
        {
            if (status != Status.Ok)
            {
                throw new AbutException(status, Text(abut_last_error_message()));
            }
        }

        internal delegate Status Fill<T>(T[] place, UIntPtr capacity, out UIntPtr count);

        /// <summary>The whole answer of a call that fills arrays of unknown length.</summary>
        internal static T[] Filled<T>(int room, Fill<T> fill)
        {
            var values = new T[room];
            while (true)
            {
                Check(fill(values, (UIntPtr)(uint)values.Length, out UIntPtr count));
                bool isComplete = (ulong)count <= (ulong)values.Length;
                Array.Resize(ref values, (int)count);
                if (isComplete)
                {
                    return values;
                }
            }
        }

        internal static string Text(IntPtr text)
        {
            return Marshal.PtrToStringAnsi(text);
        }
    }
}
