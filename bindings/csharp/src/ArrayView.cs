using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Cleft
{
    /// <summary>
    /// A read-only array that looks into the library's memory, without a copy. It keeps that memory: it stays good when
    /// the object that it came from is disposed of, and the memory is freed when the view is collected too.
    /// </summary>
    public abstract class ArrayView<T> : IReadOnlyList<T>
    {
        private readonly NativeHandle owner;
        private readonly bool held;

        internal ArrayView(NativeHandle owner, Func<NativeHandle, IntPtr> start, Func<NativeHandle, long> count)
        {
            this.owner = owner;
            owner.DangerousAddRef(ref held);
            Pointer = start(owner);
            LongCount = count(owner);
        }

        /// <summary>Lets go of the memory.</summary>
        ~ArrayView()
        {
            if (held)
                owner.DangerousRelease();
        }

        /// <summary>
        /// Where the elements lie, one after the other, for code that wants no copy: good as long as this view is
        /// reachable (GC.KeepAlive). Never write there.
        /// </summary>
        public IntPtr Pointer { get; }

        /// <summary>How many elements there are.</summary>
        public long LongCount { get; }

        /// <summary>How many elements there are, if that is less than 2^31.</summary>
        public int Count => checked((int)LongCount);

        /// <summary>Element <paramref name="index"/>.</summary>
        public T this[int index] => this[(long)index];

        /// <summary>Element <paramref name="index"/>.</summary>
        public T this[long index]
        {
            get {
                if (index < 0 || index >= LongCount)
                    throw new ArgumentOutOfRangeException(nameof(index), index, "there are " + LongCount + " elements");
                T value = Read(index);
                GC.KeepAlive(this);
                return value;
            }
        }

        /// <summary>Copies elements from <paramref name="first"/> on, as many as the array has room for.</summary>
        public void CopyTo(long first, T[] array)
        {
            if (array == null)
                throw new ArgumentNullException(nameof(array));
            if (first < 0 || first > LongCount - array.Length)
                throw new ArgumentOutOfRangeException(nameof(first), first, "there are " + LongCount + " elements");
            if (array.Length > 0)
                Copy(first, array);
            GC.KeepAlive(this);
        }

        /// <summary>All elements, in an array of your own.</summary>
        public T[] ToArray()
        {
            T[] array = new T[LongCount];
            CopyTo(0, array);
            return array;
        }

        /// <inheritdoc/>
        public IEnumerator<T> GetEnumerator()
        {
            for (long index = 0; index < LongCount; ++index)
                yield return this[index];
        }

        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }

        internal abstract T Read(long index);
        internal abstract void Copy(long first, T[] array);
    }

    internal sealed unsafe class DoubleView : ArrayView<double>
    {
        internal DoubleView(NativeHandle owner, Func<NativeHandle, IntPtr> start, Func<NativeHandle, long> count)
            : base(owner, start, count) { }

        internal override double Read(long index) { return ((double*)Pointer)[index]; }
        internal override void Copy(long first, double[] array)
        {
            Marshal.Copy((IntPtr)((double*)Pointer + first), array, 0, array.Length);
        }
    }

    internal sealed unsafe class FloatView : ArrayView<float>
    {
        internal FloatView(NativeHandle owner, Func<NativeHandle, IntPtr> start, Func<NativeHandle, long> count)
            : base(owner, start, count) { }

        internal override float Read(long index) { return ((float*)Pointer)[index]; }
        internal override void Copy(long first, float[] array)
        {
            Marshal.Copy((IntPtr)((float*)Pointer + first), array, 0, array.Length);
        }
    }

    internal sealed unsafe class IntView : ArrayView<int>
    {
        internal IntView(NativeHandle owner, Func<NativeHandle, IntPtr> start, Func<NativeHandle, long> count)
            : base(owner, start, count) { }

        internal override int Read(long index) { return ((int*)Pointer)[index]; }
        internal override void Copy(long first, int[] array)
        {
            Marshal.Copy((IntPtr)((int*)Pointer + first), array, 0, array.Length);
        }
    }
}
