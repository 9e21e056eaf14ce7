namespace UnityEngine.Playables;

public interface IPlayableBehaviour
{
}

public readonly struct FrameData
{
}

public abstract class PlayableBehaviour : IPlayableBehaviour
{
    public virtual void OnPlayableCreate(Playable playable)
    {
    }

    public virtual void OnPlayableDestroy(Playable playable)
    {
    }

    public virtual void PrepareFrame(Playable playable, FrameData info)
    {
    }

    public virtual void ProcessFrame(Playable playable, FrameData info, object? playerData)
    {
    }
}
