using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Sources;

namespace NeuronMocap.Server;

// The members that the command channel uses.
public sealed partial class Broadcaster
{
    // Null for a recording or a reader.
    internal FramePlan? Plan => _plan;

    /// <summary>Zeroes out an avatar: turns it to face front, along Z, where it stands.</summary>
    /// <remarks>
    /// The change starts at the next frame that has not been made yet. From there on the whole motion is turned about the vertical axis through the
    /// hips. In a motion packet only the values of the hips change. Calculation packets follow. You can call this method repeatedly and at any time.
    /// It is not documented whether real servers change the direction, the position or both.
    /// </remarks>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <returns>
    /// False if the avatar does not exist. Also false if the position of its hips is not a number or too far away to compute with.
    /// </returns>
    public bool ZeroOut(int avatarIndex)
    {
        if ((uint)avatarIndex >= (uint)_actors.Length)
            return false;

        return _actors[avatarIndex].FaceFront(_plan!.FrameCount);
    }

    /// <summary>Zeroes out all avatars, as <see cref="ZeroOut"/> does.</summary>
    public void ZeroOutAll()
    {
        foreach (ZeroOutSource actor in _actors)
            actor.FaceFront(_plan!.FrameCount);
    }

    // Values that are computed from a frame and its neighbours use the same turn in all of them. The turn happens between two frames, and no sensor
    // would measure it. Until the source is turned, a provider receives the same source object that the options hold.
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
