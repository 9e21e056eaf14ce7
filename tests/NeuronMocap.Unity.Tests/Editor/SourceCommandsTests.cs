using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

// The buttons of the window, with the real simulator.
public sealed class SourceCommandsTests : IDisposable
{
    private readonly EditorWorld _world = new(play: true);
    private readonly string _folderBefore = Application.Folder;
    private readonly string _folder = Directory.CreateTempSubdirectory("project").FullName;
    private readonly Broadcaster _server = new(new BroadcasterOptions { Port = 0, Sources = [new TurnedActor(70)] });
    private readonly CommandServer _commands;
    private readonly SourcesWindow _window;
    private readonly Action _draw;

    public SourceCommandsTests()
    {
        Application.Folder = _folder;
        _commands = new CommandServer(_server, new CommandServerOptions { Port = 0 });
        _server.Start();
        _commands.Start();
        _window = SourcesWindow.Open();
        _draw = (Action)Delegate.CreateDelegate(typeof(Action), _window, "OnGUI");
    }

    public void Dispose()
    {
        MainThread.Claim();
        _window.Close();
        _world.Dispose();
        _commands.Dispose();
        _server.Dispose();
        Application.Folder = _folderBefore;
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Zeroed_out_the_performer_faces_forward()
    {
        Performer performer = AddClient(_commands.LocalEndPoint!.Port).Performers[0];
        Assert.InRange(HeadingOf(performer), 60, 80);

        ImmediateGui.Click(_draw, SourcePanel.ZeroOutAll);
        _world.Loop.RunUntil(() => Says("Zeroed all avatars out"));
        Assert.Equal("Info", EditorWorld.Find("Zeroed all avatars out").Value);
        Assert.True(EditorWorld.Find(SourcePanel.ZeroOutAll).IsEnabled);

        _world.Loop.RunUntil(() => HeadingOf(performer) < 2);
    }

    [Fact]
    public void A_refused_command_port_is_an_error()
    {
        int port;
        using (var closed = new TestServer())
            port = closed.Port;

        AddClient(port);
        ImmediateGui.Click(_draw, SourcePanel.ZeroOutAll);
        _world.Loop.RunUntil(() =>
        {
            ImmediateGui.Draw(_draw);
            return EditorWorld.Controls.Any(static control => control.Kind == "HelpBox" && control.Value == "Error");
        });

        GuiControl error = EditorWorld.Controls.Single(static control => control.Kind == "HelpBox" && control.Value == "Error");
        Assert.Contains($"{port}", error.Label, StringComparison.Ordinal);
    }

    private bool Says(string text)
    {
        ImmediateGui.Draw(_draw);
        return EditorWorld.Controls.Any(control => control.Label.Contains(text, StringComparison.Ordinal));
    }

    // Degrees between the direction of the hips and forward, seen from above.
    private static float HeadingOf(Performer performer)
    {
        Vector3 forward = performer.GetRotation(Bone.Hips) * Vector3.forward;
        return Vector3.Angle(new Vector3(forward.x, 0, forward.z), Vector3.forward);
    }

    // File names cannot contain a slash.
    private MocapSource AddClient(int commandPort)
    {
        MocapSource source = _world.AddSource(
            source => (source.Port, source.CommandPort, source.Resample) = (_server.LocalEndPoint!.Port, commandPort, false), "Stage/Left");
        EditorApplication.RaiseHierarchyChanged();
        _world.Loop.RunUntil(() => source.Performers.Count == 1 && source.Performers[0].HasPose);
        return source;
    }

    // Stands still and looks to the side.
    private sealed class TurnedActor(float degrees) : MotionSource
    {
        private readonly SkeletonBody _body = SkeletonBody.GetDefault();

        public override double FrameRate => 60;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override FootContacts GetFootContacts(long frame) => new(true, true);

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            _body.CopyRestPose(pose);
            pose[0] = pose[0] with { Rotation = System.Numerics.Quaternion.CreateFromAxisAngle(System.Numerics.Vector3.UnitY, degrees * MathF.PI / 180) };
        }
    }
}
