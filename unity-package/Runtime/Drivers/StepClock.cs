#nullable enable

using System;

namespace NeuronMocap.Unity
{
    // Converts the times of physics steps to times of the source's clock. Steps run in the game's time, which stops, slows down and skips. The two
    // clocks are compared once for each rendered frame.
    internal sealed class StepClock
    {
        // Small differences are noise of the rendered frames, so they are followed slowly.
        private const double LargestNoise = 0.05;
        private const double Share = 0.1;

        private double _game;
        private double _source;
        private double _scale;

        public bool IsStarted { get; private set; }

        // game: the time of the rendered frame in the game. source: the same moment on the source's clock. Both in seconds.
        public void Follow(double game, double source, double timeScale)
        {
            double expected = IsStarted ? ToSource(game) : source;
            double error = source - expected;
            bool isNoise = timeScale > 0 && Math.Abs(error) <= LargestNoise;
            _source = isNoise ? expected + (Share * error) : source;
            _game = game;
            _scale = timeScale > 0 ? timeScale : 1;
            IsStarted = true;
        }

        public double ToSource(double game) => _source + ((game - _game) / _scale);

        public void Reset() => IsStarted = false;
    }
}
