using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Sources;

namespace NeuronMocap.Server;

// What the command channel does with a broadcast, and has to know of it.
public sealed partial class Broadcaster
{
    // Null for a recording.
    internal FramePlan? Plan => _plan;

    /// <summary>
    /// Zeroes out an avatar: turns it to face front, along Z, where it stands: from the next frame on that has not been made yet, the whole performance is turned about
    /// the vertical through its hips. Of a motion packet only the hips' values change; calculation packets follow. May be repeated, and called at any time.
    /// What real servers change, the direction, the position or both, is not documented.
    /// </summary>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <returns>False when there is no such avatar, or when its hips are nowhere: not a number, or too far away to compute with.</returns>
    public bool ZeroOut(int avatarIndex)
    {
        if ((uint)avatarIndex >= (uint)_actors.Length)
            return false;

        return _actors[avatarIndex].FaceFront(_plan!.FrameCount);
    }

    /// <summary>Does what <see cref="ZeroOut"/> does, for all avatars.</summary>
    public void ZeroOutAll()
    {
        foreach (ZeroOutSource actor in _actors)
            actor.FaceFront(_plan!.FrameCount);
    }

    // What is computed from a frame and its neighbours sees one turn in all of them: the body is turned between two frames, which no sensor would feel.
    // A writer is given the very source that the options hold for as long as it is not turned.
    private ZeroOutSource[] UseZeroOutSources()
    {
        ZeroOutSource[] actors = [.. _options.Sources.Select(static source => new ZeroOutSource(source))];
        _options.Sources = actors;
        if (_options.Calculation is { } calculate)
            _options.Calculation = (source, frame, values) => calculate(source.At(frame), frame, values);
        if (_options.StudioCalculation is { } calculateStudio)
            _options.StudioCalculation = (source, frame, payload) => calculateStudio(source.At(frame), frame, payload);

        return actors;
    }
}
