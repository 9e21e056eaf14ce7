using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Tool.View.Characters;

namespace NeuronMocap.Tool.Tests.View.Characters;

public sealed class CharacterRigTests
{
    [Theory]
    [InlineData("vroid")]
    [InlineData("mixamo")]
    public void A_map_of_VRM_names_moves_the_same_nodes_as_their_names(string name)
    {
        CharacterNode[] nodes = SampleCharacters.OfRig(name);
        var named = CharacterRig.Create(nodes);
        Dictionary<string, int> humanoid = named.Bones.ToArray()
            .Where(static bone => bone.Humanoid is not null)
            .ToDictionary(static bone => VrmBoneNames.Of(bone.Humanoid!.Value), static bone => bone.Node);
        var mapped = CharacterRig.Create(nodes, humanoid);
        Assert.Equal(humanoid.Count, mapped.Bones.Length);
        Assert.Equal(
            named.Bones.ToArray().Where(static bone => bone.Humanoid is not null).Select(static bone => (bone.Node, bone.Humanoid)),
            mapped.Bones.ToArray().Select(static bone => (bone.Node, bone.Humanoid)));
    }

    // three.js, among others, removes the colon when it loads and saves a file.
    [Theory]
    [InlineData("mixamorig")]
    [InlineData("mixamorig1:")]
    [InlineData("Armature|mixamorig:")]
    [InlineData("")]
    public void Mixamo_characters_are_found_with_any_prefix(string prefix)
    {
        CharacterNode[] nodes = SampleCharacters.OfRig("mixamo");
        CharacterNode[] renamed = [.. nodes.Select(node => node with { Name = node.Name.Replace("mixamorig:", prefix, StringComparison.Ordinal) })];
        Assert.Equal(
            CharacterRig.Create(nodes).Bones.ToArray().Select(static bone => (bone.Node, bone.Humanoid)),
            CharacterRig.Create(renamed).Bones.ToArray().Select(static bone => (bone.Node, bone.Humanoid)));
    }

    [Fact]
    public void VRM_counts_the_thumb_from_its_metacarpal_bone()
    {
        Assert.Equal("leftThumbMetacarpal", VrmBoneNames.Of(HumanoidBone.LeftThumbProximal));
        Assert.Equal("rightThumbProximal", VrmBoneNames.Of(HumanoidBone.RightThumbIntermediate));
        Assert.Equal("rightThumbDistal", VrmBoneNames.Of(HumanoidBone.RightThumbDistal));
        Assert.Equal("leftIndexProximal", VrmBoneNames.Of(HumanoidBone.LeftIndexProximal));
        Assert.Equal("upperChest", VrmBoneNames.Of(HumanoidBone.UpperChest));
        Assert.True(VrmBoneNames.TryFind("rightLittleIntermediate", out HumanoidBone bone));
        Assert.Equal(HumanoidBone.RightLittleIntermediate, bone);
    }

    [Fact]
    public void Eyes_and_toes_of_a_map_stay_at_rest()
    {
        CharacterNode[] nodes = [.. SampleCharacters.OfRig("vroid"), new("eye", 1, new Vector3(0, 0.7f, 0.1f))];
        Dictionary<string, int> humanoid = CharacterRig.Create(nodes).Bones.ToArray()
            .Where(static bone => bone.Humanoid is not null)
            .ToDictionary(static bone => VrmBoneNames.Of(bone.Humanoid!.Value), static bone => bone.Node);
        humanoid.Add("leftEye", nodes.Length - 1);
        Assert.DoesNotContain(CharacterRig.Create(nodes, humanoid).Bones.ToArray(), bone => bone.Node == nodes.Length - 1);
    }

    [Fact]
    public void A_file_without_bones_says_what_a_character_needs()
    {
        CharacterNode[] nodes = [new("Chair", -1, Vector3.Zero), new("Seat", 0, Vector3.UnitY), new("Leg", 1, Vector3.UnitX)];
        Assert.Equal("none of its nodes has the name of a bone, such as Hips, Spine or LeftArm.", Refusal(nodes));
    }

    [Fact]
    public void A_character_without_hips_says_which_bones_it_lacks()
    {
        CharacterNode[] nodes = [.. SampleCharacters.OfRig("mixamo").Select(static node => node.Name == "mixamorig:Hips" ? node with { Name = "Middle" } : node)];
        Assert.Equal("it lacks these bones: hips.", Refusal(nodes));
    }

    [Fact]
    public void A_character_without_legs_moves_and_says_what_it_lacks()
    {
        CharacterNode[] nodes = SampleCharacters.OfRig("ready-player-me");
        for (int i = 0; i < nodes.Length; i++)
        {
            if (nodes[i].Name.Contains("Leg", StringComparison.Ordinal))
                nodes[i] = nodes[i] with { Name = $"x{i}" };
        }

        string problem = Assert.Single(CharacterRig.Create(nodes).Problems);
        Assert.StartsWith("The character lacks these bones, and moves without them: left upper leg, right upper leg, left lower leg", problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Swapped_sides_are_reported()
    {
        CharacterNode[] nodes = SampleCharacters.OfRig("vroid");
        Dictionary<string, int> humanoid = CharacterRig.Create(nodes).Bones.ToArray()
            .Where(static bone => bone.Humanoid is not null)
            .ToDictionary(static bone => VrmBoneNames.Of(bone.Humanoid!.Value), static bone => bone.Node);
        foreach (string side in (string[])["left", "right"])
            humanoid.Add($"{side}Toes", Array.FindIndex(nodes, node => node.Parent == humanoid[$"{side}Foot"]));

        CharacterNode[] mirrored = [.. nodes.Select(static node => node with { Translation = node.Translation with { X = -node.Translation.X } })];
        Assert.Empty(CharacterRig.Create(nodes, humanoid).Problems);
        Assert.Contains("wrong sides", Assert.Single(CharacterRig.Create(mirrored, humanoid).Problems), StringComparison.Ordinal);
    }

    [Fact]
    public void Wrong_nodes_are_refused_in_one_sentence()
    {
        CharacterNode[] nodes = SampleCharacters.OfRig("mixamo");
        Assert.Contains("nodes", Refusal([]), StringComparison.Ordinal);
        CharacterNode[] many = [.. Enumerable.Range(0, CharacterRig.MaxNodes + 1).Select(static i => new CharacterNode($"{i}", i - 1, Vector3.One))];
        Assert.Contains("nodes", Refusal(many), StringComparison.Ordinal);
        Assert.Contains("before its parent", Refusal([nodes[0] with { Parent = 3 }, .. nodes[1..]]), StringComparison.Ordinal);
        CharacterNode infinite = nodes[0] with { Translation = new Vector3(float.PositiveInfinity) };
        Assert.Contains("not a number", Refusal([infinite, .. nodes[1..]]), StringComparison.Ordinal);
        Assert.Contains("length zero", Refusal([nodes[0] with { Rotation = default }, .. nodes[1..]]), StringComparison.Ordinal);
        Assert.Contains("scale of zero", Refusal([nodes[0] with { Scale = Vector3.Zero }, .. nodes[1..]]), StringComparison.Ordinal);
        Assert.Contains("does not exist", Refusal(nodes, new Dictionary<string, int> { ["hips"] = nodes.Length }), StringComparison.Ordinal);
        Assert.DoesNotContain("Parameter", Refusal([nodes[0] with { Rotation = default }, .. nodes[1..]]), StringComparison.Ordinal);
    }

    private static string Refusal(CharacterNode[] nodes, Dictionary<string, int>? humanoid = null) =>
        Assert.Throws<CharacterException>(() => CharacterRig.Create(nodes, humanoid)).Message;
}
