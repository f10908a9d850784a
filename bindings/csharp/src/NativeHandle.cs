using System;
using System.Runtime.InteropServices;

namespace Cleft
{
    /// <summary>
    /// The address of an object of the library. The runtime counts who needs it (calls while they run, views until they
    /// are collected), and destroys the object when its owner is disposed of or collected and nobody needs it any more.
    /// </summary>
    internal sealed class NativeHandle : SafeHandle
    {
        /// <summary>Stands for null.</summary>
        internal static readonly NativeHandle None = new NativeHandle(IntPtr.Zero, null, null);

        private readonly Action<IntPtr> destroy;
        private readonly long bytes;  // that are counted as held

        /// <summary>Owns the object at the address. <paramref name="size"/>: about how many bytes it holds.</summary>
        internal NativeHandle(IntPtr address, Action<IntPtr> destroy, Func<NativeHandle, long> size)
            : base(IntPtr.Zero, true)
        {
            this.destroy = destroy;
            SetHandle(address);
            if (size == null)
                return;
            bytes = size(this);
            NativeMemory.Add(bytes);
        }

        /// <summary>Owns an object without large arrays.</summary>
        internal NativeHandle(IntPtr address, Action<IntPtr> destroy)
            : this(address, destroy, owned => NativeSize.Small) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            destroy(handle);
            if (bytes > 0)
                NativeMemory.Remove(bytes);
            return true;
        }
    }

    /// <summary>
    /// What owns memory of the library. It is freed by <see cref="Dispose"/>, or when the object is collected; but not
    /// before the last view of it is collected too, and the last call that uses it is over.
    /// </summary>
    public abstract class NativeObject : IDisposable
    {
        private readonly NativeHandle handle;
        private volatile bool disposed;  // the handle itself is not closed before its last view is gone

        internal NativeObject(NativeHandle handle)
        {
            this.handle = handle;
            NativeMemory.MakeRoom();
        }

        /// <summary>Was <see cref="Dispose"/> called?</summary>
        public bool IsDisposed => disposed;

        /// <summary>Gives the object up. Again does nothing; views that are still held stay good.</summary>
        public void Dispose()
        {
            disposed = true;
            handle.Dispose();
        }

        /// <summary>What this is, in a few words.</summary>
        public sealed override string ToString()
        {
            return GetType().Name + (disposed ? " (disposed)" : Description);
        }

        /// <summary>What follows the name of the class in ToString().</summary>
        internal virtual string Description => "";

        internal NativeHandle Handle
        {
            get {
                if (disposed)
                    throw new ObjectDisposedException(GetType().Name);
                return handle;
            }
        }

        /// <summary>The handle of an argument that may be null.</summary>
        internal static NativeHandle HandleOf(NativeObject argument)
        {
            return argument == null ? NativeHandle.None : argument.Handle;
        }

        /// <summary>The handle of an argument that must not be null.</summary>
        internal static NativeHandle Required(NativeObject argument, string name)
        {
            if (argument == null)
                throw new ArgumentNullException(name);
            return argument.Handle;
        }
    }
}
