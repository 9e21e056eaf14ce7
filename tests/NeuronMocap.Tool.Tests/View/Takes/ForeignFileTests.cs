using System.Net;
using System.Text.Json;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.View.Takes;

/// <summary>What a person reads about files that are no takes.</summary>
public sealed class ForeignFileTests
{
    private const string Gltf = """{"asset":{"version":"2.0"},"animations":[{"channels":[]}]}""";

    [Theory]
    [InlineData("photo.jpg")]
    [InlineData("song.mp3")]
    public async Task A_dropped_file_of_another_kind_is_named_with_the_kinds_that_are_shown(string name)
    {
        await using TakeClient client = await TakeClient.StartAsync();

        JsonElement answer = await client.PostAsync(name, [0xFF, 0xFB, 0x90, 0, 1, 2, 3, 4, 5], HttpStatusCode.BadRequest);

        Assert.Equal(
            $"'{name}' is neither a take nor a character. Takes are BVH files, recordings (.nmrec), calculation exports (.calc) and raw streams (.bin, .dat). "
                + "Characters are VRM, GLB and glTF files.",
            answer.GetProperty("error").GetString());
    }

    [Fact]
    public async Task A_dropped_character_with_the_name_of_a_take_says_how_to_show_it()
    {
        await using TakeClient client = await TakeClient.StartAsync();

        JsonElement answer = await client.PostAsync("hero.bvh", "glTF\u0002\0\0\0"u8.ToArray(), HttpStatusCode.BadRequest);

        Assert.Equal("'hero.bvh' is a GLB file. To show it as a character, give its name the ending .glb and drop it again.", answer.GetProperty("error").GetString());
    }

    [Theory]
    [InlineData("hero.vrm", "glTF\u0002\0\0\0")]
    [InlineData("hero.glb", "cut")]
    [InlineData("hero.gltf", Gltf)]
    public async Task A_character_on_the_command_line_is_to_be_dropped_on_the_page(string name, string text)
    {
        using var folder = new Files.TemporaryFolder();
        folder.Write(name, text);

        ToolResult result = await ToolRunner.RunAsync("view", folder[name], "--port", "0");

        Assert.Equal(1, result.ExitCode);
        Assert.Equal($"neuron-mocap: '{name}' is a character, not a take. Start view without it, and drop it on the page.", Assert.Single(result.Error));
    }

    [Fact]
    public async Task A_skeleton_of_another_program_is_named()
    {
        await using TakeClient client = await TakeClient.StartAsync();

        JsonElement answer = await client.PostAsync("dance.bvh", System.Text.Encoding.UTF8.GetBytes(Files.Takes.TwoJoints), HttpStatusCode.BadRequest);

        Assert.StartsWith("'dance.bvh' is not a take of the 59 bones that Axis Neuron records. ", answer.GetProperty("error").GetString(), StringComparison.Ordinal);
    }
}
