namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class PhysicsTests : IDisposable
{
    private const float Step = 0.02f;

    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void A_kinematic_body_moves_in_the_next_step_and_has_a_velocity()
    {
        Rigidbody body = Add("A", null);
        body.MovePosition(new Vector3(0.1f, 0, 0));
        body.MoveRotation(Quaternion.Euler(0, 9, 0));
        Assert.Equal(Vector3.zero, body.transform.position);

        _loop.Frame(Step);
        Assert.Equal(new Vector3(0.1f, 0, 0), body.transform.position);
        Assert.Equal(5, body.velocity.x, 1e-4f);
        Assert.Equal(MathF.PI * 9 / 180 / Step, body.angularVelocity.y, 1e-3f);

        _loop.Frame(Step);
        Assert.Equal(Vector3.zero, body.velocity);
        Assert.Equal(new Vector3(0.1f, 0, 0), body.position);
    }

    [Fact]
    public void A_collider_below_a_controller_stops_it_unless_ignored()
    {
        CharacterController controller = new GameObject("Controller").AddComponent<CharacterController>();
        CapsuleCollider part = new GameObject("Part").AddComponent<CapsuleCollider>();
        part.transform.SetParent(controller.transform, false);
        Assert.Equal(CollisionFlags.Sides, controller.Move(Vector3.right));
        Assert.Equal(Vector3.zero, controller.transform.position);

        Physics.IgnoreCollision(controller, part);
        controller.Move(Vector3.right);
        Assert.Equal(Vector3.right, controller.transform.position);

        Physics.IgnoreCollision(part, controller, false);
        Assert.Equal(CollisionFlags.Sides, controller.Move(Vector3.right));
        part.isTrigger = true;
        Assert.Equal(CollisionFlags.None, controller.Move(Vector3.right));
    }

    [Fact]
    public void Placing_a_body_or_its_transform_gives_no_velocity()
    {
        Rigidbody body = Add("A", null);
        _loop.Frame(Step);
        body.position = Vector3.up;
        Assert.Equal(Vector3.zero, body.transform.position);
        _loop.Frame(Step);
        Assert.Equal(Vector3.up, body.transform.position);
        Assert.Equal(Vector3.zero, body.velocity);

        body.transform.position = Vector3.right;
        Assert.Equal(Vector3.up, body.position);
        _loop.Frame(Step);
        Assert.Equal(Vector3.right, body.position);
        Assert.Equal(Vector3.zero, body.velocity);
    }

    [Fact]
    public void A_transform_carries_the_bodies_below_it_without_a_velocity()
    {
        var parent = new GameObject("Parent");
        Rigidbody body = Add("A", parent.transform);
        _loop.Frame(Step);

        parent.transform.position = Vector3.right;
        Physics.SyncTransforms();
        body.MovePosition(new Vector3(1.1f, 0, 0));
        _loop.Frame(Step);

        Assert.Equal(0.1f / Step, body.velocity.x, 1e-3f);
    }

    [Fact]
    public void A_transform_that_physics_has_not_seen_takes_moves_and_places_away()
    {
        var parent = new GameObject("Parent");
        Rigidbody moved = Add("Moved", parent.transform);
        Rigidbody placed = Add("Placed", parent.transform);
        _loop.Frame(Step);

        parent.transform.position = Vector3.right;
        Assert.Equal(Vector3.zero, moved.position);
        moved.MovePosition(new Vector3(1.1f, 0, 0));
        placed.position = Vector3.up;
        _loop.Frame(Step);

        Assert.Equal((Vector3.right, Vector3.zero), (moved.transform.position, moved.velocity));
        Assert.Equal(Vector3.right, placed.transform.position);
    }

    [Fact]
    public void A_body_below_a_body_reaches_its_own_place_in_the_world()
    {
        Rigidbody lower = Add("Lower", null);
        Rigidbody upper = Add("Upper", null);
        lower.transform.SetParent(upper.transform);
        upper.MovePosition(Vector3.up);
        upper.MoveRotation(Quaternion.Euler(0, 0, 90));
        lower.MovePosition(Vector3.right);

        _loop.Frame(Step);

        Assert.Equal(0, (Vector3.right - lower.transform.position).magnitude, 1e-5f);
        Assert.Equal(Vector3.right / Step, lower.velocity);
        Assert.Equal(Vector3.up / Step, upper.velocity);
    }

    [Fact]
    public void In_a_step_times_are_those_of_the_step()
    {
        var times = new List<(bool InStep, float Time, float Delta)>();
        StepProbe probe = new GameObject("A").AddComponent<StepProbe>();
        probe.OnStep = () => times.Add((Time.inFixedTimeStep, Time.time, Time.unscaledDeltaTime));

        _loop.Frame(0.05f);

        Assert.Equal([(true, Step, Step), (true, 2 * Step, Step)], times);
        Assert.False(Time.inFixedTimeStep);
        Assert.Equal(0.05f, Time.time);
        Assert.Equal(2 * Step, Time.fixedTime);
    }

    private static Rigidbody Add(string name, Transform? parent)
    {
        var holder = new GameObject(name);
        holder.transform.SetParent(parent);
        Rigidbody body = holder.AddComponent<Rigidbody>();
        body.isKinematic = true;
        return body;
    }
}

public sealed class StepProbe : MonoBehaviour
{
    public Action? OnStep { get; set; }

    private void FixedUpdate() => OnStep?.Invoke();
}
