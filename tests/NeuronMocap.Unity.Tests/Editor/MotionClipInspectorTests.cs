using NeuronMocap.Unity.Timeline;
using NeuronMocap.Unity.Timeline.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed class MotionClipInspectorTests : IDisposable
{
    private static readonly string Takes = Path.Combine(Repository.Root, "samples", "takes");

    private readonly EditorWorld _world = new();
    private readonly MotionClip _clip = ScriptableObject.CreateInstance<MotionClip>();
    private readonly MotionClipEditor _inspector;

    public MotionClipInspectorTests()
    {
        // The assembly must be loaded before the editor looks for inspectors.
        Assert.NotNull(typeof(MotionClipEditor).Assembly);
        _inspector = Assert.IsType<MotionClipEditor>(_world.Inspect(_clip));
    }

    public void Dispose()
    {
        EditorUtility.NextFile = "";
        _world.Dispose();
    }

    [Theory]
    [InlineData("walk.bvh", @"^.*walk\.bvh: \d+\.\d\d s, [\d,]+ frames, [\d.]+ /s$")]
    [InlineData("walk.nmrec", @"^.+ in .*walk\.nmrec: \d+\.\d\d s, [\d,]+ frames, [\d.]+ /s$")]
    public void The_dialog_chooses_a_file_and_the_take_is_described(string file, string description)
    {
        Draw();
        Assert.Contains("no file", Assert.Single(EditorWorld.Labels("HelpBox")), StringComparison.Ordinal);
        EditorUtility.NextFile = Path.Combine(Takes, file);

        ImmediateGui.Click(_inspector.OnInspectorGUI, MotionClipEditor.Browse);
        Draw();

        Assert.Equal(EditorUtility.NextFile, _clip.File);
        Assert.Empty(EditorWorld.Labels("HelpBox"));
        Assert.Contains(EditorWorld.Labels("Label"), label => System.Text.RegularExpressions.Regex.IsMatch(label, description, default, TimeSpan.FromMinutes(1)));

        EditorUtility.NextFile = "";
        ImmediateGui.Click(_inspector.OnInspectorGUI, MotionClipEditor.Browse);
        Assert.Equal(Path.Combine(Takes, file), _clip.File);
    }

    [Theory]
    [InlineData("missing.bvh", null)]
    [InlineData("empty.bvh", "")]
    [InlineData("other.bvh", "HIERARCHY\nROOT Box\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n0 0 0\n")]
    [InlineData("noise.nmrec", "noise")]
    public void A_file_that_cannot_be_used_is_an_error_until_it_is_read_again(string name, string? content)
    {
        string folder = Directory.CreateTempSubdirectory("takes").FullName;
        try
        {
            _clip.File = Path.Combine(folder, name);
            if (content is not null)
                File.WriteAllText(_clip.File, content);

            Draw();
            GuiControl box = Assert.Single(EditorWorld.Controls, static control => control.Kind == "HelpBox");
            Assert.Equal("Error", box.Value);
            Assert.Contains(name, box.Label, StringComparison.Ordinal);

            File.Copy(Path.Combine(Takes, "walk" + Path.GetExtension(name)), _clip.File, overwrite: true);
            ImmediateGui.Click(_inspector.OnInspectorGUI, MotionClipEditor.ReadAgain);
            Draw();
            Assert.Empty(EditorWorld.Labels("HelpBox"));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void A_text_asset_is_named()
    {
        _clip.FileAsset = new TextAsset(File.ReadAllText(Path.Combine(Takes, "walk.bvh"))) { name = "Walk" };
        Draw();

        Assert.Contains(EditorWorld.Labels("Label"), static label => label.StartsWith("Walk: ", StringComparison.Ordinal));
    }

    [Fact]
    public void Several_clips_show_their_fields_only()
    {
        ImmediateGui.Draw(_world.Inspect(_clip, ScriptableObject.CreateInstance<MotionClip>()).OnInspectorGUI);

        Assert.Empty(EditorWorld.Labels("HelpBox"));
        Assert.Contains("File", EditorWorld.Labels("Property"));
    }

    private void Draw() => ImmediateGui.Draw(_inspector.OnInspectorGUI);
}
