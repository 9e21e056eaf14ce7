namespace UnityEngine.StandIn;

/// <summary>The physics step after each FixedUpdate: it notices transforms that scripts have changed, moves all bodies, and lets their transforms follow.</summary>
internal static class PhysicsStep
{
    private static readonly List<Rigidbody> _bodies = [];

    public static void Add(Rigidbody body) => _bodies.Add(body);

    public static void Clear() => _bodies.Clear();

    public static void SyncTransforms()
    {
        foreach (Rigidbody body in _bodies)
        {
            if (body.IsSimulated)
                body.Sync();
        }
    }

    public static void Run(float seconds)
    {
        for (int i = _bodies.Count - 1; i >= 0; i--)
        {
            if (_bodies[i].IsDestroyed)
                _bodies.RemoveAt(i);
        }

        Sort();
        SyncTransforms();
        foreach (Rigidbody body in _bodies)
        {
            if (body.IsSimulated)
                body.Simulate(seconds);
        }

        foreach (Rigidbody body in _bodies)
        {
            if (body.IsSimulated)
                body.Show();
        }

        foreach (Rigidbody body in _bodies)
        {
            if (body.IsSimulated)
                body.EndStep();
        }
    }

    // Parents first. Allocates nothing, because tests measure frames.
    private static void Sort()
    {
        for (int i = 1; i < _bodies.Count; i++)
        {
            Rigidbody body = _bodies[i];
            int depth = body.Depth;
            int place = i;
            for (; place > 0 && _bodies[place - 1].Depth > depth; place--)
                _bodies[place] = _bodies[place - 1];

            _bodies[place] = body;
        }
    }
}
