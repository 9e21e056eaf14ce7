namespace NeuronMocap.Recording;

// What the playback does next.
internal enum PlaybackTurn
{
    Play,
    Step,
    StepBack,
    Seek,
    Stop,
}
