namespace NeuronMocap.Motion;

// Reconstructs the sender's even clock from uneven arrivals: a straight line of arrival times over frame numbers, fitted by least squares.
//
// The fit is recursive. It predicts the next arrival, and corrects position and period by fixed shares of the error. Up to Memory frames, the
// shares are those of a fit over all frames so far. The line is therefore usable after a few frames and then hardly moves, but it follows the drift
// of clocks.
//
// The error of a single late frame is limited to three times the mean deviation. If all errors have the same sign, the rate has changed or a frame
// without a number is missing. The fit then starts again with the latest frames.
internal sealed class SenderClock
{
    private const int Memory = 200;
    private const int ShortMemory = 3;
    private const double LargestError = 0.25;
    private const double OutlierDeviations = 3;
    private const double BiasWeight = 0.3;
    private const double BiasPeriods = 0.6;
    private const double DeviationWeight = 0.05;

    private uint? _index;
    private double _arrival;
    private double _position;
    private double _time;
    private double _deviation;
    private double _bias;
    private int _count;
    private int _steps;

    // Before the fit settles, frames that a server sends together have arbitrary times, and a speed between them has no meaning.
    public bool IsSettled => _steps >= 2 * ShortMemory;

    // Seconds for each step of the index; 0 before the second frame.
    public double Period { get; private set; }

    // Mean deviation of arrivals from the even clock, in seconds.
    public double Jitter => _deviation;

    // Seconds from one frame to the next. For example, if every second index is missing, this is twice the period.
    public double Interval { get; private set; }

    // Returns the time of a frame on the even clock; null for a duplicate.
    public double? Place(double arrival, uint? index)
    {
        if (_count == 0)
            return Start(arrival, index);

        int step = index is { } number && _index is { } last ? unchecked((int)(number - last)) : 1;
        if (step == 0)
        {
            // A duplicate datagram arrives soon after the first. Otherwise the counter does not advance, and its value is ignored.
            if (arrival - _arrival < Interval / 2)
                return null;

            step = 1;
        }

        // A late frame arrives between others. If no frame has arrived for a long time, or the period is still unknown, the counter has restarted.
        if (step < 0 && Period > 0 && -step * Period < LargestError && arrival - _arrival < LargestError)
            return _time + (step * Period);

        double error = arrival - (_position + (step * Period));
        bool isFirstStep = _count == 1 && Period == 0;
        if (step < 0 || Math.Abs(isFirstStep ? error / step : error) > LargestError)
            return Restart(arrival, index);

        Advance(step, error);
        _arrival = arrival;
        _index = index;
        return _time;
    }

    private double Start(double arrival, uint? index)
    {
        _count = 1;
        _arrival = arrival;
        _index = index;
        _position = arrival;
        _time = arrival;
        return arrival;
    }

    // The sender paused, or another sender took over. Time continues at the known rate until a new rate is measured.
    private double Restart(double arrival, uint? index)
    {
        double earliest = _time + Interval;
        _bias = 0;
        Start(arrival, index);
        _count = Period > 0 ? ShortMemory : 1;
        _time = Math.Max(arrival, earliest);
        return _time;
    }

    private void Advance(int step, double error)
    {
        _steps = Math.Min(_steps + 1, Memory);
        if (_count > ShortMemory)
        {
            _bias += BiasWeight * (error - _bias);
            if (Math.Abs(_bias) > BiasPeriods * Interval)
            {
                _bias = 0;
                _count = ShortMemory;
            }
        }

        _count = Math.Min(_count + 1, Memory);
        bool settled = _count > 2 * ShortMemory;
        double limit = settled ? OutlierDeviations * Math.Max(_deviation, Interval / 100) : double.PositiveInfinity;
        double counted = Math.Max(-limit, Math.Min(limit, error));
        double k = _count;
        double before = _position;
        _position += (step * Period) + (counted * 2 * ((2 * k) - 1) / (k * (k + 1)));
        Period = Math.Max(0, Period + (counted * 6 / (k * (k + 1)) / step));
        Interval += Math.Max(0.1, 2.0 / _count) * ((step * Period) - Interval);
        if (_count > 2)
            _deviation += Math.Max(DeviationWeight, 1 / k) * (Math.Abs(error) - _deviation);

        // Frames keep their order even while the slope of the line still changes.
        _time = Math.Max(_position, _time + Math.Max(1e-4, (_position - before) / 4));
    }
}
