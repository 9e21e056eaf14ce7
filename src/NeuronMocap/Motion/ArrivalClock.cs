namespace NeuronMocap.Motion;

// Finds the sender's even clock in uneven arrivals: the straight line of arrival times over frame numbers, fitted by least squares.
//
// The fit is the recursive one: predict the next arrival, correct position and period by fixed shares of the error. The shares are those of a
// fit over all frames so far until there are Memory of them, so a line stands after a few frames and then hardly moves, yet follows the drift of
// clocks. A single late frame counts as late as frames usually are. When the errors all point one way, the rate has changed or a frame without
// number is missing, and the fit begins again with the newest frames.
internal sealed class ArrivalClock
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

    // Before there is a line, frames that a server sends at once lie anywhere, and there is no speed between them.
    public bool IsSettled => _steps >= 2 * ShortMemory;

    // Seconds for each step of the index; 0 before the second frame.
    public double Period { get; private set; }

    // Seconds by which arrivals usually miss the even clock.
    public double Jitter => _deviation;

    // Seconds from one frame to the next, where every second index is missing, say, twice the period.
    public double Interval { get; private set; }

    // When a frame was on the even clock; null for one that was there before.
    public double? Place(double arrival, uint? index)
    {
        if (_count == 0)
            return Start(arrival, index);

        int step = index is { } number && _index is { } last ? unchecked((int)(number - last)) : 1;
        if (step == 0)
        {
            // A datagram that came twice comes close; a counter that stands still is none.
            if (arrival - _arrival < Interval / 2)
                return null;

            step = 1;
        }

        // Late frames come between others. Where none goes on for so long, or there is no period yet to tell how late they are, the counter went back.
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

    // The sender paused, or is another one. Time goes on, at the rate that was known until another one shows.
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

        // Frames keep their order while the line still turns.
        _time = Math.Max(_position, _time + Math.Max(1e-4, (_position - before) / 4));
    }
}
