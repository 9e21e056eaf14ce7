using System.Text.RegularExpressions;
using NeuronMocap.Unity.Samples;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEngine.InputSystem;

namespace NeuronMocap.Unity.Tests.Samples;

/// <summary>The keys of the samples. With the Input System alone, OnGUI gets no clicks and no mouse.</summary>
public sealed partial class SampleKeyTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public SampleKeyTests() => Keyboard.current = new Keyboard();

    public void Dispose()
    {
        Keyboard.current = null;
        _loop.Dispose();
    }

    [Fact]
    public void Every_button_names_a_key_that_its_script_reads()
    {
        int buttons = 0;
        foreach (string path in Directory.GetFiles(Path.Combine(Repository.Root, "unity-package", "Samples~"), "*.cs", SearchOption.AllDirectories))
        {
            string script = File.ReadAllText(path);
            foreach (Match label in Label().Matches(script).SelectMany(static line => Text().Matches(line.Value)))
            {
                buttons++;
                Match key = KeyName().Match(label.Value);
                Assert.True(key.Success, $"{Path.GetFileName(path)}: {label.Value}");
                Assert.Contains(key.Groups["key"].Value is "{_source.RecenterKey}" ? "_source.RecenterKey" : $"KeyPresses.IsPressed(KeyCode.{key.Groups["key"].Value})", script, StringComparison.Ordinal);
            }
        }

        Assert.Equal(10, buttons);
    }

    [Fact]
    public void Performers_come_and_go_with_keys()
    {
        Crowd crowd = new GameObject("Crowd").AddComponent<Crowd>();
        MocapSource source = crowd.Source = Stage.AddSimulator(performers: 2);
        Press(Key.M);
        Assert.Equal(3, source.PerformerCount);
        Press(Key.F);
        Assert.Equal(2, source.PerformerCount);
    }

    [Fact]
    public void Boxes_are_put_back_with_a_key()
    {
        BoxCourse course = new GameObject("Course").AddComponent<BoxCourse>();
        _loop.Frame();
        Transform box = course.Boxes[0].transform;
        Vector3 place = box.localPosition;
        box.localPosition = Vector3.zero;
        Press(Key.P);
        Assert.Equal(place, box.localPosition);
    }

    [Fact]
    public void A_take_starts_and_ends_with_a_key()
    {
        string folder = Directory.CreateTempSubdirectory("desk").FullName;
        try
        {
            MotionRecorder recorder = new GameObject("Recorder").AddComponent<MotionRecorder>();
            (recorder.Source, recorder.Folder) = (Stage.AddSimulator(), folder);
            TakeDesk desk = new GameObject("Desk").AddComponent<TakeDesk>();
            (desk.Recorder, desk.RecordAtStart) = (recorder, 0);
            Press(Key.R);
            _loop.RunUntil(() => recorder.Frames > 5);
            Press(Key.R);
            _loop.RunUntil(() => recorder.State == RecorderState.Idle);
        }
        finally
        {
            _loop.Dispose();
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void The_noise_changes_with_keys()
    {
        NoisySuit suit = new GameObject("Suit").AddComponent<NoisySuit>();
        Press(Key.M);
        Assert.Equal(3, suit.Noise);
        Press(Key.L);
        Assert.Equal(2, suit.Noise);
    }

    [Fact]
    public void The_stage_is_mirrored_with_a_key()
    {
        StageDesk desk = new GameObject("Desk").AddComponent<StageDesk>();
        MocapSource source = desk.Mirrored = Stage.AddSimulator();
        Press(Key.M);
        Assert.True(source.Stage.Mirror);
        Press(Key.M);
        Assert.False(source.Stage.Mirror);
    }

    [Fact]
    public void Arrow_keys_look_around()
    {
        Transform head = new GameObject("Head").AddComponent<MouseLook>().transform;
        Press(Key.RightArrow);
        Press(Key.UpArrow);
        Assert.True(Quaternion.Angle(Quaternion.Euler(-10, 10, 0), head.localRotation) < 0.01f, $"{head.localRotation}");
        Press(Key.LeftArrow);
        Press(Key.DownArrow);
        Assert.True(Quaternion.Angle(Quaternion.identity, head.localRotation) < 0.01f, $"{head.localRotation}");
    }

    private void Press(Key key)
    {
        Keyboard.current!.Press(key);
        _loop.Frame();
    }

    [GeneratedRegex(@"GUILayout\.(Button|Toggle)\(.*", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Label();

    [GeneratedRegex("\"[^\"]+\"", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Text();

    [GeneratedRegex(@"\(key (?<key>[^)]+)\)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex KeyName();
}
