using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Commands.CommandCall;

namespace NeuronMocap.Tests.Commands;

// Requests, and the results of their answers.
public class CommandAnswerTests
{
    private static readonly byte[] HeaderText = Encoding.ASCII.GetBytes(BvhHierarchyText.Create(SkeletonFormat.Default, default));

    public static TheoryData<string, byte[]> Requests => new()
    {
        { nameof(NeuronCommandClient.ZeroOutAsync), [0xFF, 0xAA, 0, 0, 0xE9, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xBB, 5, 0, 0, 0] },
        { nameof(NeuronCommandClient.ZeroOutAllAsync), [0xFF, 0xAA, 0, 0, 0xEA, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xBB] },
        { nameof(NeuronCommandClient.GetRotationOrderAsync), [0xFF, 0xAA, 0, 0, 0xEB, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xBB] },
        { nameof(NeuronCommandClient.GetBoneDimensionsAsync), [0xFF, 0xAA, 0, 0, 0xEC, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xBB, 5, 0, 0, 0] },
        { nameof(NeuronCommandClient.GetBvhHeaderTextAsync), [0xFF, 0xAA, 0, 0, 0xED, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xBB, 5, 0, 0, 0] },
    };

    [Theory, MemberData(nameof(Requests))]
    public async Task A_request_has_the_bytes_of_the_protocol(string call, byte[] expected)
    {
        byte[] sent = [];
        using var server = new CommandScript(request =>
        {
            sent = request.Packet;
            return request.ReplyAsync(Answer(request.Id));
        });
        using NeuronCommandClient client = server.CreateClient();
        await CallAsync(client, call, avatar: 5);

        Assert.Equal(expected, sent);
    }

    [Theory, EverySplitting]
    public async Task Answers_arrive_in_any_pieces(Splitting splitting)
    {
        using var server = new CommandScript(request => ReplyInPiecesAsync(request, splitting));
        using NeuronCommandClient client = server.CreateClient();
        int variants = splitting == Splitting.EverySplitInTwo ? CommandChannelHeader.Size + BoneDimensions.Size - 1 : 1;
        for (int i = 0; i < variants; i++)
        {
            Assert.Equal(Sizes(i), await client.GetBoneDimensionsAsync(i).Soon());
            Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
        }

        if (splitting != Splitting.EverySplitInTwo)
            Assert.Equal(HeaderText, Encoding.ASCII.GetBytes(await client.GetBvhHeaderTextAsync(0).Soon()));
    }

    [Theory]
    [InlineData(0, RotationOrder.XZY)]
    [InlineData(1, RotationOrder.YXZ)]
    [InlineData(2, RotationOrder.XYZ)]
    [InlineData(3, RotationOrder.YZX)]
    [InlineData(4, RotationOrder.ZXY)]
    [InlineData(5, RotationOrder.ZYX)]
    public async Task The_rotation_order_is_read_from_one_byte_or_four(byte number, RotationOrder expected)
    {
        foreach (byte[] payload in (byte[][])[[number], [number, 0], [number, 0, 0, 0], [number, 0, 0, 0, 9]])
        {
            using var server = CommandScript.Always(payload);
            using NeuronCommandClient client = server.CreateClient();
            Assert.Equal(expected, await client.GetRotationOrderAsync().Soon());
        }
    }

    [Theory]
    [InlineData(6, 0)]
    [InlineData(255, 0)]
    [InlineData(1, 1)]
    [InlineData(255, 255)]
    public async Task An_unknown_rotation_order_is_an_invalid_answer(byte low, byte high)
    {
        using var server = CommandScript.Always([low, 0, 0, high]);
        using NeuronCommandClient client = server.CreateClient();
        await FailsAsync(client.GetRotationOrderAsync(), CommandFailure.InvalidReply, "it must be 0 to 5");
    }

    [Fact]
    public async Task Bone_sizes_may_be_longer_but_not_shorter()
    {
        byte[] sizes = Bytes(Sizes(3));
        using (var server = CommandScript.Always([.. sizes, 1, 2, 3]))
        using (NeuronCommandClient client = server.CreateClient())
            Assert.Equal(Sizes(3), await client.GetBoneDimensionsAsync(0).Soon());

        using (var server = CommandScript.Always(sizes[..47]))
        using (NeuronCommandClient client = server.CreateClient())
            await FailsAsync(client.GetBoneDimensionsAsync(0), CommandFailure.InvalidReply, "47 bytes");
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(-0.1f)]
    public async Task Impossible_bone_sizes_are_an_invalid_answer(float wrong)
    {
        using var server = CommandScript.Always(Bytes(Sizes(1) with { LowerLeg = wrong }));
        using NeuronCommandClient client = server.CreateClient();
        await FailsAsync(client.GetBoneDimensionsAsync(0), CommandFailure.InvalidReply, "bone sizes");
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(3)]
    public async Task The_header_is_read_with_and_without_a_terminator(int zeros)
    {
        using var server = CommandScript.Always([.. HeaderText, .. new byte[zeros]]);
        using NeuronCommandClient client = server.CreateClient();

        BvhDocument document = await client.GetBvhHeaderAsync(0).Soon();
        Assert.Equal(59, document.Joints.Count);
        Assert.Equal(Encoding.ASCII.GetString(HeaderText), await client.GetBvhHeaderTextAsync(0).Soon());
    }

    [Theory]
    [InlineData("BVH")]
    [InlineData("HIERARCHY")]
    [InlineData(" ")]
    [InlineData("HIERARCHY\nROOT i\n{OFFSET")]
    public async Task Text_that_is_not_BVH_is_an_invalid_answer(string text)
    {
        using var server = CommandScript.Always(Encoding.ASCII.GetBytes(text));
        using NeuronCommandClient client = server.CreateClient();
        await FailsAsync(client.GetBvhHeaderAsync(0), CommandFailure.InvalidReply, "BVH header");
        await FailsAsync(client.GetBvhHeaderTextAsync(0), CommandFailure.InvalidReply, "BVH header");
    }

    [Theory]
    [InlineData(true, 1, 0, 0, 0)]
    [InlineData(true, 2)]
    [InlineData(true, 255, 255, 255, 255)]
    [InlineData(false, 0, 1, 0, 0)]
    [InlineData(false, 0)]
    [InlineData(false)]
    public async Task A_zero_out_succeeds_when_the_first_byte_is_not_zero(bool isDone, params int[] payload)
    {
        using var server = CommandScript.Always([.. payload.Select(value => (byte)value)]);
        using NeuronCommandClient client = server.CreateClient();
        foreach (Task call in (Task[])[client.ZeroOutAsync(2), client.ZeroOutAllAsync()])
        {
            if (isDone)
                await call.Soon();
            else
                await FailsAsync(call, CommandFailure.Rejected, "did not zero out");
        }
    }

    [Fact]
    public async Task An_empty_answer_means_not_available()
    {
        using var server = CommandScript.Always([]);
        using NeuronCommandClient client = server.CreateClient();
        await FailsAsync(client.GetBoneDimensionsAsync(7), CommandFailure.Rejected, "avatar 7");
        await FailsAsync(client.GetBvhHeaderAsync(7), CommandFailure.Rejected, "avatar 7");
        await FailsAsync(client.GetRotationOrderAsync(), CommandFailure.Rejected, "no answer");
    }

    [Fact]
    public void Wrong_arguments_and_settings_are_refused()
    {
        using var client = new NeuronCommandClient("127.0.0.1");
        Assert.Throws<ArgumentOutOfRangeException>(() => { _ = client.ZeroOutAsync(-1); });
        Assert.Throws<ArgumentOutOfRangeException>(() => { _ = client.GetBoneDimensionsAsync(-1); });
        Assert.Throws<ArgumentOutOfRangeException>(() => { _ = client.GetBvhHeaderAsync(-1); });
        Assert.Throws<ArgumentNullException>(() => new NeuronCommandClient((NeuronCommandOptions)null!));
        Refuses(static options => options.Host = " ", "Host");
        Refuses(static options => options.Host = "127.0.0.1:8013", "Host is 127.0.0.1:8013; it must be a name or address alone. Set Port,");
        Refuses(static options => options.Host = "[::1]:8013", "Host is [::1]:8013; it must be a name or address alone. Set Port,");
        Refuses(static options => options.Port = 0, "Port");
        Refuses(static options => options.Port = 65_536, "Port");
        Refuses(static options => options.ConnectTimeout = TimeSpan.Zero, "ConnectTimeout");
        Refuses(static options => options.Timeout = TimeSpan.Zero, "Timeout");
        Refuses(static options => options.Timeout = TimeSpan.FromHours(1), "Timeout");
        Refuses(static options => options.MaxReplySize = 47, "MaxReplySize");
        Refuses(static options => options.MaxReplySize = 200_017, "MaxReplySize");
    }

    internal static BoneDimensions Sizes(int avatar) => new() { Head = 0.2f, Neck = avatar, LowerLeg = 0.5f, FootLength = 0.25f };

    internal static byte[] Bytes(BoneDimensions sizes)
    {
        byte[] bytes = new byte[BoneDimensions.Size];
        sizes.Write(bytes);
        return bytes;
    }

    private static void Refuses(Action<NeuronCommandOptions> change, string setting)
    {
        var options = new NeuronCommandOptions();
        change(options);
        Assert.Contains(setting, Assert.Throws<ArgumentException>(() => new NeuronCommandClient(options)).Message, StringComparison.Ordinal);
    }

    private static byte[] Answer(int id) => id switch
    {
        1003 => [4, 0, 0, 0],
        1004 => Bytes(Sizes(5)),
        1005 => HeaderText,
        _ => [1, 0, 0, 0],
    };

    private static async Task ReplyInPiecesAsync(ScriptedRequest request, Splitting splitting)
    {
        byte[] payload = request.Id == 1004 ? Bytes(Sizes(request.Avatar)) : Answer(request.Id);
        byte[] packet = CommandScript.Packet(payload, request.Id);
        IEnumerable<ArraySegment<byte>>[] variants = [.. Splits.Of(packet, splitting)];
        int variant = request.Id == 1004 ? request.Avatar : 0;
        foreach (ArraySegment<byte> piece in variants[variant % variants.Length])
        {
            await request.Connection.SendAsync(piece);
            await Task.Yield();
        }
    }

    private static Task CallAsync(NeuronCommandClient client, string call, int avatar) => call switch
    {
        nameof(NeuronCommandClient.ZeroOutAsync) => client.ZeroOutAsync(avatar).Soon(),
        nameof(NeuronCommandClient.ZeroOutAllAsync) => client.ZeroOutAllAsync().Soon(),
        nameof(NeuronCommandClient.GetRotationOrderAsync) => client.GetRotationOrderAsync().Soon(),
        nameof(NeuronCommandClient.GetBoneDimensionsAsync) => client.GetBoneDimensionsAsync(avatar).Soon(),
        _ => client.GetBvhHeaderTextAsync(avatar).Soon(),
    };
}
