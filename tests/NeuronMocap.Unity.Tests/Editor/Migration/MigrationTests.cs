using NeuronMocap.Retargeting;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor.Migration;

/// <summary>The conversion of an open scene in which the vendor's scripts compile.</summary>
public sealed class MigrationTests : IDisposable
{
    private readonly VendorProject _project = new(hasScripts: true);

    public void Dispose() => _project.Dispose();

    [Fact]
    public void Performers_of_one_address_share_a_source()
    {
        NeuronAnimatorInstance first = Add<NeuronAnimatorInstance>("First", static instance => instance.actorID = 2);
        NeuronAnimatorInstance second = Add<NeuronAnimatorInstance>("Second");
        Animator animator = new GameObject("Model").AddComponent<Animator>();
        second.boundAnimator = animator;
        GameObject[] owners = [first.gameObject, second.gameObject];

        IReadOnlyList<MigrationItem> items = Migrate();

        Assert.Equal(
            ["Humanoid Driver, performer 2 of a new Mocap Source, 127.0.0.1:7001", "Humanoid Driver, performer 0 of the Mocap Source, 127.0.0.1:7001"],
            items.Select(static item => item.Change));
        MocapSource source = Assert.Single(Object.FindObjectsOfType<MocapSource>());
        Assert.Equal((SourceKind.Network, "127.0.0.1", 7001, TransportKind.Tcp), (source.Kind, source.Address, source.Port, source.Transport));
        HumanoidDriver[] drivers = [.. owners.Select(static owner => owner.GetComponent<HumanoidDriver>())];
        Assert.All(drivers, driver => Assert.Same(source, driver.Source));
        Assert.Equal([2, 0], drivers.Select(static driver => driver.PerformerIndex));
        Assert.Same(animator, drivers[1].Animator);
        Assert.Equal((RootMotion.Full, 0f, true), (drivers[0].RootMotion, drivers[0].HeightOffset, drivers[0].enabled));
        Assert.True(first == null && second == null);
        Assert.All(items, static item => Assert.Empty(item.Notes));
    }

    [Fact]
    public void Every_setting_with_an_equal_is_taken_over()
    {
        var root = new GameObject("Rig");
        Neuron.NeuronTransformsInstance rig = Add<Neuron.NeuronTransformsInstance>("Holder", instance =>
            (instance.root, instance.prefix, instance.socketType, instance.port, instance.useNewRig) = (root.transform, "Suit_", Neuron.SocketKind.UDP, 7004, false));
        NeuronAnimatorInstance other = Add<NeuronAnimatorInstance>("Other", static instance =>
        {
            (instance.address, instance.port, instance.hipHeightOffset) = ("10.0.0.5", 7005, 0.135f);
            (instance.enableHipsMovement, instance.connectToAxis, instance.physicalUpdate) = (false, false, true);
        });
        (GameObject holder, GameObject figure) = (rig.gameObject, other.gameObject);

        IReadOnlyList<MigrationItem> items = Migrate();

        GenericRigDriver generic = holder.GetComponent<GenericRigDriver>();
        Assert.Equal((root.transform, "Suit_"), (generic.Root, generic.Prefix));
        Assert.Equal((TransportKind.Udp, 7004, SkeletonVariantSetting.Spine3), (generic.Source!.Transport, generic.Source.Port, generic.Source.SkeletonVariant));
        HumanoidDriver driver = figure.GetComponent<HumanoidDriver>();
        Assert.Equal(("10.0.0.5", 7005, SkeletonVariantSetting.Auto), (driver.Source!.Address, driver.Source.Port, driver.Source.SkeletonVariant));
        Assert.Equal((RootMotion.InPlace, false), (driver.RootMotion, driver.enabled));
        Assert.Equal(0.1f, driver.HeightOffset, 1e-6f);
        Assert.Equal(4, items.Single(static item => item.Place.StartsWith("Other", StringComparison.Ordinal)).Notes.Count);
    }

    [Fact]
    public void A_source_of_the_scene_is_used_again()
    {
        MocapSource source = new GameObject("Mine").AddComponent<MocapSource>();
        GameObject owner = Add<NeuronAnimatorInstance>("Figure").gameObject;

        Migrate();

        Assert.Same(source, owner.GetComponent<HumanoidDriver>().Source);
        Assert.Single(Object.FindObjectsOfType<MocapSource>());
    }

    [Fact]
    public void One_Undo_brings_everything_back()
    {
        NeuronAnimatorInstance first = Add<NeuronAnimatorInstance>("First", static instance => instance.port = 7009);
        Neuron.NeuronTransformsInstance second = Add<Neuron.NeuronTransformsInstance>("Second");
        Migrate();
        Assert.True(first == null);

        Undo.PerformUndo();

        Assert.Same(first, GameObject.Find("First")!.GetComponent<NeuronAnimatorInstance>());
        Assert.Same(second, GameObject.Find("Second")!.GetComponent<Neuron.NeuronTransformsInstance>());
        Assert.Equal(7009, first!.port);
        Assert.Empty(Object.FindObjectsOfType<FigureDriver>());
        Assert.Empty(Object.FindObjectsOfType<MocapSource>());
        Assert.Equal(2, EditorTools.Migration.Examine().Count);
    }

    [Fact]
    public void A_dry_run_changes_nothing_and_lists_the_same()
    {
        NeuronAnimatorInstance first = Add<NeuronAnimatorInstance>("First");
        Add<NeuronInstancesManager>("Manager");
        int objects = Infrastructure.Measure.LiveObjects;

        string[] planned = [.. EditorTools.Migration.Examine().Select(static item => item.ToString())];

        Assert.Equal(objects, Infrastructure.Measure.LiveObjects);
        Assert.True(first != null);
        Assert.Empty(Undo.Names);
        Assert.False(first.gameObject.scene.isDirty);
        Assert.Equal(planned, EditorTools.Migration.Convert().Select(static item => item.ToString()));
        Assert.True(GameObject.Find("First")!.scene.isDirty);
    }

    [Fact]
    public void A_second_run_finds_nothing()
    {
        Add<NeuronAnimatorInstance>("Figure");
        Migrate();

        Assert.Empty(EditorTools.Migration.Examine());
    }

    [Theory]
    [InlineData(typeof(NeuronInstancesManager), "Performer Spawner")]
    [InlineData(typeof(Neuron.NeuronInstance), "moves nothing")]
    [InlineData(typeof(RewrittenInstance), "derives from NeuronAnimatorInstance")]
    public void What_has_no_equal_is_left_with_a_reason(Type type, string reason)
    {
        Component component = new GameObject("Holder").AddComponent(type);

        MigrationItem item = Assert.Single(Migrate());

        Assert.Contains(reason, item.Reason, StringComparison.Ordinal);
        Assert.Equal($"Holder: {type.Name}", item.Place);
        Assert.True(component != null);
        Assert.Empty(Undo.Names);
    }

    [Fact]
    public void What_cannot_be_replaced_is_left_with_a_reason()
    {
        Add<NeuronAnimatorInstance>("Driven").gameObject.AddComponent<HumanoidDriver>();
        Add<NeuronAnimatorInstance>("Required").gameObject.AddComponent<InstanceUser>();
        Add<NeuronAnimatorInstance>("Port", static instance => instance.port = 0);
        Add<NeuronAnimatorInstance>("Actor", static instance => instance.actorID = -1);
        Add<NeuronAnimatorInstance>("Twice").gameObject.AddComponent<Neuron.NeuronTransformsInstance>();

        IReadOnlyList<MigrationItem> items = Migrate();

        string Reason(string place) => items.Single(item => item.Place.StartsWith(place, StringComparison.Ordinal)).Reason;
        Assert.Contains("already has a driver", Reason("Driven"), StringComparison.Ordinal);
        Assert.Contains("InstanceUser on the same object requires it", Reason("Required"), StringComparison.Ordinal);
        Assert.Contains("port is 0", Reason("Port"), StringComparison.Ordinal);
        Assert.Contains($"actor ID is {-1}", Reason("Actor"), StringComparison.Ordinal);
        Assert.Empty(Reason("Twice: NeuronAnimatorInstance"));
        Assert.Contains("already has a driver", Reason("Twice: NeuronTransformsInstance"), StringComparison.Ordinal);
        Assert.Equal(5, Object.FindObjectsOfType<Neuron.NeuronInstance>().Length);
        Assert.Empty(ConsoleLog.Problems);
    }

    private static T Add<T>(string name, Action<T>? set = null)
        where T : MonoBehaviour
    {
        T added = new GameObject(name).AddComponent<T>();
        set?.Invoke(added);
        return added;
    }

    private static IReadOnlyList<MigrationItem> Migrate() => EditorTools.Migration.Convert();
}
