using System.Globalization;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Functions;

// tests/native/receiver.cpp: a C++98 program whose objects receive the callbacks.
public sealed class CppProgramTests
{
    [Fact]
    public async Task Cpp_objects_get_their_callbacks()
    {
        using var server = new TestServer();
        await using NativeProgram program = NativeProgram.Start("receiver", server.Port.ToString(CultureInfo.InvariantCulture), "400");
        using TestConnection connection = await server.AcceptAsync();
        for (int i = 0; i < 100; i++)
        {
            await connection.SendPiecesAsync(
                TestPackets.Join(
                    TestPackets.Motion(i, avatar: 0, name: "Char00"),
                    TestPackets.Motion(i, avatar: 1, name: "陈", count: 180),
                    TestPackets.Calculation(i),
                    TestPackets.Motion(i, avatar: 2, name: "Char02", layout: HeaderLayout.Old)),
                1400);
        }

        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
        Assert.Equal(
            [
                @"2 Service is stoped",
                Line("Char00", TestPackets.Value(99, 0, 353)),
                Line("Char02", TestPackets.Value(99, 2, 353)),
                Line("陈", TestPackets.Value(99, 1, 179)),
                "calculations 100",
            ],
            program.ReadRest());
    }

    private static string Line(string name, float last) => string.Create(CultureInfo.InvariantCulture, $"{name} 100 {last:G6}");
}
