namespace UnityEngine.Playables;

public interface IPlayable
{
    PlayableHandle GetHandle();
}

public readonly struct PlayableHandle
{
    internal PlayableHandle(PlayableNode node) => Node = node;

    internal PlayableNode? Node { get; }

    internal PlayableNode Checked => Node ?? throw new NullReferenceException("The playable is null.");
}

public readonly struct Playable : IPlayable
{
    private readonly PlayableHandle _handle;

    internal Playable(PlayableNode node) => _handle = new PlayableHandle(node);

    public static Playable Null => default;

    public PlayableHandle GetHandle() => _handle;
}

public readonly struct ScriptPlayable<T> : IPlayable
    where T : class, IPlayableBehaviour, new()
{
    private readonly PlayableHandle _handle;

    private ScriptPlayable(PlayableHandle handle) => _handle = handle;

    public static ScriptPlayable<T> Create(PlayableGraph graph, int inputCount = 0) => Create(graph, new T(), inputCount);

    public static ScriptPlayable<T> Create(PlayableGraph graph, T template, int inputCount = 0)
    {
        var node = new PlayableNode((PlayableBehaviour)(object)template, inputCount);
        graph.Add(node);
        return new ScriptPlayable<T>(new PlayableHandle(node));
    }

    public PlayableHandle GetHandle() => _handle;

    public T GetBehaviour() => (T)(object)_handle.Checked.Behaviour;

    public static implicit operator Playable(ScriptPlayable<T> playable) => new(playable._handle.Checked);

    public static explicit operator ScriptPlayable<T>(Playable playable) => playable.GetHandle().Checked.Behaviour is T
        ? new ScriptPlayable<T>(playable.GetHandle())
        : throw new InvalidCastException($"The playable has no {typeof(T).Name}.");
}

public static class PlayableExtensions
{
    public static bool IsValid<U>(this U playable)
        where U : struct, IPlayable => playable.GetHandle().Node is { IsDestroyed: false };

    public static int GetInputCount<U>(this U playable)
        where U : struct, IPlayable => playable.GetHandle().Checked.Inputs.Length;

    public static Playable GetInput<U>(this U playable, int inputPort)
        where U : struct, IPlayable => playable.GetHandle().Checked.Inputs[inputPort] is { } node ? new Playable(node) : default;

    public static float GetInputWeight<U>(this U playable, int inputIndex)
        where U : struct, IPlayable => playable.GetHandle().Checked.Weights[inputIndex];

    public static void SetInputWeight<U>(this U playable, int inputIndex, float weight)
        where U : struct, IPlayable => playable.GetHandle().Checked.Weights[inputIndex] = weight;

    public static double GetTime<U>(this U playable)
        where U : struct, IPlayable => playable.GetHandle().Checked.Time;

    public static void SetTime<U>(this U playable, double value)
        where U : struct, IPlayable => playable.GetHandle().Checked.Time = value;

    public static void ConnectInput<U, V>(this U playable, int inputIndex, V sourcePlayable, int sourceOutputIndex)
        where U : struct, IPlayable
        where V : struct, IPlayable => playable.GetHandle().Checked.Inputs[inputIndex] = sourcePlayable.GetHandle().Checked;
}
