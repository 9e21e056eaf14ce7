namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class DestroyTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public DestroyTests() => Probe.Clear();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void A_destroyed_object_equals_null_and_throws()
    {
        var item = new GameObject("A");
        Transform part = item.transform;

        Object.DestroyImmediate(item);

        Assert.True(item == null && part == null && !item);
        Assert.False(item is null);
        Assert.Equal("null", item.ToString());
        Assert.Throws<MissingReferenceException>(() => item!.name);
        Assert.Throws<MissingReferenceException>(() => part!.position);
    }

    [Fact]
    public void Destroying_a_root_destroys_its_tree()
    {
        var root = new GameObject("root");
        Probe child = new GameObject("child").AddComponent<Probe>();
        child.transform.SetParent(root.transform);
        Probe.Clear();

        Object.Destroy(root);
        _loop.Frame(0.001f);

        Assert.Equal(["child.Start", "child.Update", "child.LateUpdate", "child.OnDisable", "child.OnDestroy"], Probe.Calls);
        Assert.False(child);
        Assert.Empty(Object.FindObjectsOfType<GameObject>(true));
    }

    [Fact]
    public void A_delay_is_kept()
    {
        var item = new GameObject("A");
        Object.Destroy(item, 1);

        _loop.Frames(3, 0.3f);
        Assert.True(item);
        _loop.Frame(0.3f);
        Assert.False(item);
    }

    [Fact]
    public void Required_components_cannot_be_destroyed()
    {
        var item = new GameObject("A");
        item.AddComponent<Needy>();

        Object.DestroyImmediate(item.GetComponent<Animator>());
        Object.DestroyImmediate(item.transform);

        Assert.True(item.GetComponent<Animator>());
        Assert.Equal(2, ConsoleLog.Problems.Count());
    }

    [Fact]
    public void Edit_mode_allows_only_DestroyImmediate()
    {
        using var loop = new PlayerLoop(play: false);
        var item = new GameObject("A");
        item.AddComponent<Probe>();
        Object.Destroy(item);
        loop.Frame();

        Assert.True(item);
        Assert.Contains("DestroyImmediate", Assert.Single(ConsoleLog.Problems).Message, StringComparison.Ordinal);
        Assert.Empty(Probe.Calls);
    }

    [RequireComponent(typeof(Animator))]
    private sealed class Needy : MonoBehaviour
    {
    }
}
