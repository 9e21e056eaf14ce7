using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Functions;

// An internal fault is reported only as the function's failure and the last error. In C, an exception would end the process.
public sealed class FaultTests
{
    public static TheoryData<Exception> Faults => new((Exception[])
    [
        new InvalidOperationException("As meant."), new InsufficientMemoryException(), new InsufficientExecutionStackException(), new TypeInitializationException("Type", null),
    ]);

    public static TheoryData<string> CallbackMembers => new(typeof(IVendorCallbacks).GetMethods().Select(static method => method.Name));

    [Theory]
    [MemberData(nameof(Faults), DisableDiscoveryEnumeration = true)]
    public void A_fault_fails_the_function_and_sets_the_last_error(Exception fault)
    {
        LastErrorReset();

        Assert.Equal(-1, FunctionGuard.Call(0, _ => throw fault, failure: -1, "TheFunction"));

        string text = NeuronDataReader.strBRGetLastErrorMessage();
        Assert.EndsWith(".", text.TrimEnd(')', '\''), StringComparison.Ordinal);
        Assert.True(fault is OutOfMemoryException ? text.Contains("memory", StringComparison.Ordinal) : text.StartsWith("TheFunction failed because of an error in the library: ", StringComparison.Ordinal), text);
    }

    // The exception belongs to the program, which interrupts its own threads.
    [Fact]
    public void ThreadInterruptedException_is_rethrown() =>
        Assert.Throws<ThreadInterruptedException>(static () => FunctionGuard.Call(0, static _ => throw new ThreadInterruptedException(), failure: 0));

    [Fact]
    public void A_fault_while_opening_returns_zero_and_leaves_no_socket()
    {
        var socket = new ScriptedSocket(nameof(A_fault_while_opening_returns_zero_and_leaves_no_socket)) { Opening = Throw };

        Assert.Throws<InvalidOperationException>(() => SocketTable.Open(socket));

        Assert.Equal(1, socket.Released);
        Assert.DoesNotContain(socket, SocketTable.GetAll());
    }

    [Fact]
    public void A_fault_while_asking_or_closing_sets_the_last_error()
    {
        var socket = new ScriptedSocket(nameof(A_fault_while_asking_or_closing_sets_the_last_error)) { Releasing = Throw };
        IntPtr handle = SocketTable.Open(socket);
        socket.AskingForState = Throw;

        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(handle));
        Assert.StartsWith("BRGetSocketStatus failed", NeuronDataReader.strBRGetLastErrorMessage(), StringComparison.Ordinal);
        NeuronDataReader.BRCloseSocket(handle);
        Assert.StartsWith("BRCloseSocket failed", NeuronDataReader.strBRGetLastErrorMessage(), StringComparison.Ordinal);

        // Runs on its own threads, where an exception would end the process.
        LastErrorReset();
        Assert.True(VendorSession.End(Limits.Unexpected));
        SocketTable.Remove(socket);
    }

    [Fact]
    public void A_socket_that_is_already_in_the_table_is_released()
    {
        const string name = nameof(A_socket_that_is_already_in_the_table_is_released);
        var first = new ScriptedSocket(name);
        var second = new ScriptedSocket(name);
        IntPtr handle = SocketTable.Open(first);

        Assert.Equal(handle, SocketTable.Open(second));

        Assert.Equal((0, 1), (first.Released, second.Released));
        NeuronDataReader.BRCloseSocket(handle);
        Assert.Equal((1, 1), (first.Released, second.Released));
    }

    // On the receive thread, on the thread that reports the end, and on threads that connect and close.
    [Theory]
    [MemberData(nameof(CallbackMembers))]
    public async Task A_fault_around_a_callback_keeps_the_thread_and_connection_alive(string member)
    {
        IVendorCallbacks callbacks = FaultyCallbacks.Of(member);
        using var server = new TestServer();
        var functions = new VendorFunctions(callbacks);
        CompatibilityEvents.CallbackFailed += Ignore;
        try
        {
            IntPtr socket = functions.Connect("127.0.0.1", server.Port);
            Assert.NotEqual(IntPtr.Zero, socket);
            using TestConnection connection = await server.AcceptAsync();
            for (int i = 0; i < 3; i++)
                await connection.SendAsync(TestPackets.Join(TestPackets.Motion(i), TestPackets.Calculation(i), DataReplies.AvatarCount(2)));
            await Limits.UntilAsync(() => ((FaultyCallbacks)callbacks).Calls >= (member == nameof(IVendorCallbacks.OnStatus) ? 2 : 3));
            Assert.Equal(SocketState.Running, VendorFunctions.GetStatus(socket));

            connection.Close();
            await Limits.UntilAsync(() => VendorFunctions.GetStatus(socket) == SocketState.OffWork);
            VendorFunctions.Close(socket);
        }
        finally
        {
            CompatibilityEvents.CallbackFailed -= Ignore;
        }

        static void Ignore(Exception exception)
        {
        }
    }

    private static void LastErrorReset() => LastError.Set("No error.");

    private static void Throw() => throw new InvalidOperationException("As meant.");
}
