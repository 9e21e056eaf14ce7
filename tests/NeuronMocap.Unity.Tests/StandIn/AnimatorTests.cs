namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class AnimatorTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void An_animator_writes_after_Update()
    {
        Animator animator = Add(out Func<int> writes);
        _loop.Frames(4, Time.fixedDeltaTime / 2);
        Assert.Equal(4, writes());

        animator.enabled = false;
        _loop.Frames(4);
        Assert.Equal(4, writes());
    }

    [Fact]
    public void An_animator_in_physics_writes_in_fixed_updates()
    {
        Add(out Func<int> writes).updateMode = AnimatorUpdateMode.AnimatePhysics;
        _loop.Frames(6, Time.fixedDeltaTime / 2);
        Assert.Equal(3, writes());

        _loop.Frame(Time.fixedDeltaTime * 2);
        Assert.Equal(5, writes());
    }

    [Theory]
    [InlineData(AnimatorCullingMode.AlwaysAnimate, 2)]
    [InlineData(AnimatorCullingMode.CullUpdateTransforms, 0)]
    [InlineData(AnimatorCullingMode.CullCompletely, 0)]
    public void A_culled_animator_writes_only_while_a_renderer_is_seen(AnimatorCullingMode mode, int hidden)
    {
        Animator animator = Add(out Func<int> writes);
        animator.cullingMode = mode;
        MeshRenderer renderer = animator.gameObject.AddComponent<MeshRenderer>();
        renderer.IsInView = false;
        _loop.Frames(2);
        Assert.Equal(hidden, writes());

        renderer.IsInView = true;
        _loop.Frames(2);
        Assert.Equal(hidden + 2, writes());
    }

    private static Animator Add(out Func<int> writes)
    {
        int count = 0;
        Animator animator = new GameObject("Figure").AddComponent<Animator>();
        animator.Animating = () => count++;
        writes = () => count;
        return animator;
    }
}
