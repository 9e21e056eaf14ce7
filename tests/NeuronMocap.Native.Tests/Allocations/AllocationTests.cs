using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Allocations;

// The classes of the library in this process, where managed memory can be counted exactly.
public sealed class AllocationTests
{
    private const int Warm = 500;
    private const int Frames = 3000;

    public static TheoryData<string, byte[]> Packets => new()
    {
        { "motion", TestPackets.Motion(1) },
        { "motion with the old header", TestPackets.Motion(1, layout: HeaderLayout.Old) },
        { "calculation", TestPackets.Calculation(1) },
        { "a line of text", TestPackets.Line(1) },
    };

    [Theory]
    [MemberData(nameof(Packets), DisableDiscoveryEnumeration = true)]
    public async Task A_frame_allocates_nothing_on_the_receive_thread(string name, byte[] packet)
    {
        _ = name;
        using var server = new TestServer();
        using var meter = new Meter();
        var callbacks = new NativeCallbacks();
        callbacks.SetFrame(meter.Pointer, Callback);
        callbacks.SetCalculation(meter.Pointer, Callback);
        IntPtr socket = new VendorFunctions(callbacks).Connect("127.0.0.1", server.Port);
        try
        {
            using TestConnection connection = await server.AcceptAsync();
            byte[] block = TestPackets.Join(Enumerable.Repeat(packet, 10));
            for (int sent = 0; sent < Frames; sent += 10)
                await connection.SendAsync(block);

            Assert.Equal(0, await meter.Allocated.Soon());
        }
        finally
        {
            VendorFunctions.Close(socket);
        }
    }

    private static unsafe IntPtr Callback => (IntPtr)(delegate* unmanaged[Stdcall]<IntPtr, IntPtr, IntPtr, IntPtr, void>)&OnFrame;

    [UnmanagedCallersOnly(CallConvs = [typeof(CallConvStdcall)])]
    private static void OnFrame(IntPtr customObject, IntPtr socket, IntPtr header, IntPtr data) =>
        ((Meter)GCHandle.FromIntPtr(customObject).Target!).OnFrame();

    // Counts what the calling thread allocates from the end of the warm-up to the last frame.
    private sealed class Meter : IDisposable
    {
        private readonly TaskCompletionSource<long> _allocated = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private GCHandle _handle;
        private int _frames;
        private int _thread;
        private long _before;

        public Meter() => _handle = GCHandle.Alloc(this);

        public IntPtr Pointer => GCHandle.ToIntPtr(_handle);

        public Task<long> Allocated => _allocated.Task;

        public void OnFrame()
        {
            _frames++;
            if (_frames == Warm)
            {
                _thread = Environment.CurrentManagedThreadId;
                _before = GC.GetAllocatedBytesForCurrentThread();
            }
            else if (_frames == Frames)
            {
                long allocated = GC.GetAllocatedBytesForCurrentThread() - _before;
                _allocated.SetResult(_thread == Environment.CurrentManagedThreadId ? allocated : -1);
            }
        }

        public void Dispose() => _handle.Free();
    }
}
