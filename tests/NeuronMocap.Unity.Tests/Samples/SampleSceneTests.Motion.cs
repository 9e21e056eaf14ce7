using NeuronMocap.Unity.Samples;
using UnityEngine.Playables;

namespace NeuronMocap.Unity.Tests.Samples;

// The samples of stages, Timeline, physics and smoothing.
public sealed partial class SampleSceneTests
{
    [Fact]
    public void Two_sources_show_a_figure_and_its_mirror_image()
    {
        Read("TwoSources").Build();
        StageDesk desk = Find<StageDesk>();
        FigureBuilder figure = FindNamed<FigureBuilder>("Figure");
        FigureBuilder image = FindNamed<FigureBuilder>("Mirrored figure");
        _loop.RunUntil(() => figure.Driver.IsDriving && image.Driver.IsDriving);
        Moves(() => figure.Figure);

        // Each source takes the time of its own update, so the two may differ in single frames.
        _loop.RunUntil(() => IsMirrored(0.003f));

        // The walker goes on. On a busy computer, it can be far away after a single frame.
        _loop.RunUntil(() =>
        {
            if (DistanceFromCenter() < 0.5f)
                return true;

            Click(desk, "Recenter (key R)");
            return false;
        });
        _loop.RunUntil(() => IsMirrored(0.2f));

        Click(desk, "Undo Recenter (key U)");
        _loop.Frame();
        Assert.InRange(DistanceFromCenter(), 0.8f, 1.2f);
        _loop.RunUntil(() => IsMirrored(0.003f));
        Assert.Equal(KeyCode.R, desk.Source!.RecenterKey);

        // The mirror stands in the middle between the two stages.
        bool IsMirrored(float tolerance) =>
            Difference(Bone.Hips, Bone.Hips) < tolerance && Difference(Bone.LeftHand, Bone.RightHand) < tolerance && Difference(Bone.RightFoot, Bone.LeftFoot) < tolerance;

        float Difference(Bone bone, Bone other)
        {
            Vector3 place = figure.Figure!.GetBone(bone).position;
            return (new Vector3(place.x, place.y, -4 - place.z) - image.Figure!.GetBone(other).position).magnitude;
        }

        float DistanceFromCenter()
        {
            Vector3 hips = desk.Source!.Performers[0].GetPosition(Bone.Hips);
            return new Vector3(hips.x, 0, hips.z).magnitude;
        }
    }

    [Fact]
    public void The_walker_is_moved_by_its_character_controller()
    {
        CharacterController.Floor = 0;
        Read("TwoSources").Build();
        StageDesk desk = Find<StageDesk>();
        CharacterController controller = Find<CharacterController>();
        HumanoidDriver driver = controller.GetComponent<HumanoidDriver>();
        Vector3 start = controller.transform.position;

        _loop.RunUntil(() => (controller.transform.position - start).magnitude > 0.3f);
        Assert.Equal(string.Empty, driver.Problem);
        Assert.True(controller.isGrounded);
        Vector3 hips = controller.GetComponent<FigureBuilder>().Figure!.GetBone(Bone.Hips).position - controller.transform.position;
        Assert.True(new Vector3(hips.x, 0, hips.z).magnitude < 0.05f);
        Assert.Contains(Shown(desk), static text => text.StartsWith("The walker is ", StringComparison.Ordinal));
    }

    [Fact]
    public void A_Timeline_blends_a_recording_and_a_file()
    {
        Read("Timeline").Build();
        PlayableDirector director = Find<PlayableDirector>();
        FigureBuilder builder = Find<FigureBuilder>();
        _loop.RunUntil(() => builder.Figure is not null);
        Assert.Equal(6.5, director.playableAsset!.duration);

        Quaternion walk = ArmAt(1);
        Quaternion before = ArmAt(2.49);
        Quaternion half = ArmAt(3);
        Quaternion after = ArmAt(3.51);
        Assert.True(Quaternion.Angle(walk, after) > 20);
        Assert.InRange(Quaternion.Angle(before, half), 3, Quaternion.Angle(before, after) - 3);
        Assert.DoesNotContain(ConsoleLog.Entries, static entry => entry.Type != LogType.Log && entry.Message != TimelineNote.Text);

        Quaternion ArmAt(double time)
        {
            director.time = time;
            director.Evaluate();
            _loop.Frame();
            Assert.True(builder.Driver.IsPosed);
            return builder.Figure!.GetBone(Bone.RightArm).localRotation;
        }
    }

    // The variant for players stands for a project without the package.
    [Fact]
    public void Without_the_package_the_sample_of_Timeline_says_what_to_install()
    {
        Read("Timeline").Build();
        _loop.Frame();

        bool isExpected = !TimelineNote.HasTimeline;
        Assert.Equal(isExpected, Shown(Find<TimelineNote>()).Contains(TimelineNote.Text));
        Assert.Equal(isExpected, ConsoleLog.Entries.Any(static entry => entry.Message == TimelineNote.Text));
    }

    [Fact]
    public void The_figure_runs_into_boxes_with_the_speed_of_its_legs_and_holds_a_bat()
    {
        Read("Physics").Build();
        BoxCourse course = Find<BoxCourse>();
        FigureBuilder builder = course.Builder!;
        _loop.RunUntil(() => builder.Driver.IsDriving && course.Bat != null);

        Rigidbody[] parts = Parts();
        Assert.Equal(20, parts.Length);
        Assert.All(parts, static part => Assert.True(part.isKinematic));
        Assert.Equal(11, course.Boxes.Count);
        Assert.All(course.Boxes, static box => Assert.True(!box.isKinematic && box.useGravity && box.GetComponent<BoxCollider>() != null));

        // The stand-in moves no boxes, so the legs go through.
        _loop.RunUntil(IsHit);

        Rigidbody bat = course.Bat!.GetComponent<Rigidbody>();
        Transform hand = builder.Figure!.GetBone(Bone.RightHand);
        Assert.True(bat.isKinematic);
        _loop.RunUntil(() => bat.velocity.magnitude > 0.2f);
        Assert.InRange((bat.position - hand.position).magnitude, 0.2f, 0.4f);

        // Shapes have a material of the figure, also after it was built again.
        builder.Rebuild();
        _loop.Frame();
        Assert.Same(builder.Figure!.Renderer.sharedMaterials[1], bat.GetComponent<Renderer>().sharedMaterial);
        Assert.All(course.Boxes, box => Assert.Same(builder.Figure.Renderer.sharedMaterials[1], box.GetComponent<Renderer>().sharedMaterial));
        Assert.Equal(20, Parts().Length);

        course.Boxes[0].transform.localPosition = Vector3.zero;
        (course.Boxes[0].velocity, course.Boxes[0].angularVelocity) = (Vector3.right, Vector3.up);
        course.PutBack();
        Assert.Equal(1, course.Boxes[0].transform.localPosition.magnitude, 0.1f);
        Assert.Equal((Vector3.zero, Vector3.zero), (course.Boxes[0].velocity, course.Boxes[0].angularVelocity));
        Assert.False(course.Boxes[0].isKinematic);

        Rigidbody[] Parts() => builder.Figure!.Root.GetComponentsInChildren<Rigidbody>();

        bool IsHit() => Parts().Any(part => part.velocity.magnitude > 0.3f && course.Boxes.Any(box => Contains(box.transform, part.position)));
    }

    [Fact]
    public void Smoothing_removes_noise_beside_the_motion_as_it_comes()
    {
        Read("Smoothing").Build();
        NoisySuit suit = Find<NoisySuit>();
        FigureBuilder raw = FindNamed<FigureBuilder>("Raw figure");
        FigureBuilder smooth = FindNamed<FigureBuilder>("Smooth figure");
        _loop.RunUntil(() => raw.Driver.IsDriving && smooth.Driver.IsDriving);
        PerformerOverlay overlay = Find<PerformerOverlay>();
        _loop.RunUntil(() => overlay.Lines.Any(static line => line.Contains("jitter", StringComparison.Ordinal)));

        // With equal frames: the noise is that of the performer, not of the sampling.
        suit.Source!.Resample = false;
        (float rawSteps, float smoothSteps) = (0, 0);
        (Quaternion Raw, Quaternion Smooth) last = Heads();
        var patience = System.Diagnostics.Stopwatch.StartNew();
        for (int steps = 0; steps < 60;)
        {
            Assert.True(patience.Elapsed < Limits.Unexpected, $"Only {steps} steps have a single frame.");
            double time = suit.Source.Performers[0].Time;
            _loop.RunUntil(() => suit.Source.Performers[0].Time != time);
            (Quaternion Raw, Quaternion Smooth) now = Heads();

            // A busy computer leaves frames out. In such a step, there is more motion than noise.
            if (suit.Source.Performers[0].Time - time < 0.025)
            {
                rawSteps += Quaternion.Angle(last.Raw, now.Raw);
                smoothSteps += Quaternion.Angle(last.Smooth, now.Smooth);
                steps++;
            }

            last = now;
        }

        Assert.True(rawSteps > 1.2f * smoothSteps, $"{rawSteps} and {smoothSteps}");

        Click(suit, "More noise (key M)");
        Assert.Equal(3, suit.Noise);
        Assert.Contains(Shown(suit), static text => text.Contains($"{3:0.0} degrees", StringComparison.Ordinal));

        (Quaternion Raw, Quaternion Smooth) Heads() => (raw.Figure!.GetBone(Bone.Head).localRotation, smooth.Figure!.GetBone(Bone.Head).localRotation);
    }

    private static T FindNamed<T>(string name)
        where T : Component => World.Objects.OfType<T>().Single(item => item.name == name);

    private static bool Contains(Transform box, Vector3 point)
    {
        Vector3 place = box.InverseTransformPoint(point);
        return Mathf.Abs(place.x) < 0.5f && Mathf.Abs(place.y) < 0.5f && Mathf.Abs(place.z) < 0.5f;
    }
}
