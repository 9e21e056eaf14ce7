using System.Diagnostics;
using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Running;

/// <summary>Runs inputs through one target and checks its behaviour. Used by one thread. Another thread may query how long an input runs.</summary>
internal sealed class InputRunner(FuzzTarget target)
{
    // One of this many inputs is read twice, with different surroundings, and must give the same result.
    private const int Sample = 8;

    private readonly FuzzTest _test = target.CreateTest();
    private readonly FuzzInput _input = new();
    private byte[] _current = [];
    private long _started;

    /// <summary>The longest time for an input.</summary>
    public TimeSpan Slowest { get; private set; }

    /// <summary>The number of items recognised in all inputs.</summary>
    public long Found { get; private set; }

    /// <summary>Returns the current limit violation and its input, or null if there is none. Any thread.</summary>
    public (FuzzFailure Failure, byte[] Input)? FindOverrun()
    {
        long started = Volatile.Read(ref _started);
        if (started == 0)
            return null;

        byte[] input = Volatile.Read(ref _current);
        if (Stopwatch.GetElapsedTime(started) > target.TimeLimit)
            return (new FuzzFailure("hang", $"An input of {input.Length} bytes takes longer than {target.TimeLimit.TotalSeconds} s."), input);

        long output = target.CountOutput?.Invoke() ?? 0;
        return output > target.OutputPerInput
            ? (new FuzzFailure("output", $"{output} bytes are written for an input of {input.Length}; {target.OutputPerInput} are allowed."), input)
            : null;
    }

    /// <summary>Runs one input.</summary>
    /// <param name="input">Any bytes.</param>
    /// <param name="isThorough">Whether it is always read a second time with different surroundings.</param>
    /// <returns>The failure, or null.</returns>
    public FuzzFailure? Run(ReadOnlySpan<byte> input, bool isThorough = false)
    {
        Remember(input);
        long start = Stopwatch.GetTimestamp();
        Volatile.Write(ref _started, start);
        FuzzFailure? failure = Check(input, isThorough);
        Volatile.Write(ref _started, 0);
        TimeSpan time = Stopwatch.GetElapsedTime(start);
        Slowest = time > Slowest ? time : Slowest;
        return failure;
    }

    // The monitor shows the input of a thread that does not return, so the copy must not be in use elsewhere.
    private void Remember(ReadOnlySpan<byte> input)
    {
        if (_current.Length != input.Length)
            Volatile.Write(ref _current, new byte[input.Length]);

        input.CopyTo(_current);
    }

    private FuzzFailure? Check(ReadOnlySpan<byte> input, bool isThorough)
    {
        FuzzFailure? failure = CheckOnce(input, Surroundings.Tokens, out long allocated);
        Found += _input.Found;

        // Objects created once, such as caches of types, do not count for the input.
        long allowed = target.AllocatedPerInput + (target.AllocatedPerByte * input.Length);
        if (failure is null && allocated > allowed)
            failure = CheckOnce(input, Surroundings.Tokens, out allocated);
        if (failure is null && allocated > allowed)
            return new FuzzFailure("allocation", $"{allocated} bytes are allocated for an input of {input.Length}; {allowed} are allowed.");
        if (failure is not null || !(isThorough || Digest.Of(input) % Sample == 0))
            return failure;

        ulong digest = _input.Digest.Value;
        failure = CheckOnce(input, Surroundings.Digits, out _);
        return failure is null && _input.Digest.Value != digest
            ? new FuzzFailure("surroundings", "The result depends on bytes outside of the input.")
            : failure;
    }

    private long CountAllocated() => target.AllocatesOnOtherThreads ? GC.GetTotalAllocatedBytes(precise: false) : GC.GetAllocatedBytesForCurrentThread();

    // The innermost method of the library. Two faults with the same exception are thus reported as two.
    private static string PlaceOf(Exception exception)
    {
        foreach (StackFrame frame in new StackTrace(exception).GetFrames())
        {
            if (frame.GetMethod() is { DeclaringType: { } type } method && type.FullName?.StartsWith("NeuronMocap.", StringComparison.Ordinal) == true)
                return $"{type.FullName}.{method.Name}";
        }

        return string.Empty;
    }

    private FuzzFailure? CheckOnce(ReadOnlySpan<byte> input, Surroundings surroundings, out long allocated)
    {
        _input.Set(input, surroundings);
        long before = CountAllocated();
        allocated = 0;
        try
        {
            _test(_input);
        }
        catch (WrongResultException exception)
        {
            return new FuzzFailure("wrong result", exception.Message);
        }
        catch (Exception exception) when (target.Refusal?.IsInstanceOfType(exception) != true)
        {
            return new FuzzFailure(exception.GetType().Name, exception.ToString()) { Place = PlaceOf(exception) };
        }
        catch (Exception)
        {
            // This is the documented rejection.
        }

        allocated = CountAllocated() - before;
        return _input.IsTouched(input, surroundings) ? new FuzzFailure("written", "The input or bytes beside it were written to.") : null;
    }
}
