using System.Collections;
using System.Reflection;
using System.Runtime.ExceptionServices;
using NUnit.Framework;
using UnityEngine.TestTools;
using Assert = Xunit.Assert;

namespace NeuronMocap.Unity.Tests.InPackage;

/// <summary>
/// Runs one test as Unity's test runner does: new object, set-up, as many frames as needed, tear-down, and no error in the log.
/// </summary>
internal sealed class PackageTest
{
    private const BindingFlags Public = BindingFlags.Instance | BindingFlags.Public;

    private readonly PlayerLoop _loop;
    private readonly object _fixture;

    private PackageTest(PlayerLoop loop, object fixture)
    {
        _loop = loop;
        _fixture = fixture;
    }

    public static TheoryData<string> Find(string assembly) =>
        [.. GetTests(assembly).SelectMany(static method => GetArguments(method).Select((_, index) => $"{method.DeclaringType!.Name}.{method.Name}#{index}"))];

    public static void Run(string assembly, string name, bool play)
    {
        MethodInfo test = GetTests(assembly).Single(method => name.StartsWith($"{method.DeclaringType!.Name}.{method.Name}#", StringComparison.Ordinal));
        object?[] arguments = GetArguments(test).ElementAt(int.Parse(name.Split('#')[1], System.Globalization.CultureInfo.InvariantCulture));
        using var loop = new PlayerLoop(play);
        LogAssert.Clear();
        var run = new PackageTest(loop, Activator.CreateInstance(test.DeclaringType!)!);
        run.CallAll(typeof(SetUpAttribute), typeof(UnitySetUpAttribute));
        try
        {
            run.Call(test, arguments);
            LogAssert.Check(isEnd: true, everything: false);
        }
        finally
        {
            run.CallAll(typeof(UnityTearDownAttribute), typeof(TearDownAttribute));
        }
    }

    private static MethodInfo[] GetTests(string assembly)
    {
        MethodInfo[] tests = [.. Assembly.Load(assembly).GetTypes().SelectMany(static type => type.GetMethods(Public)).Where(static method => GetArguments(method).Any())];
        Assert.NotEmpty(tests);
        return tests;
    }

    private static IEnumerable<object?[]> GetArguments(MethodInfo method)
    {
        if (method.IsDefined(typeof(TestAttribute)) || method.IsDefined(typeof(UnityTestAttribute)))
            return [[]];

        return method.GetCustomAttributes<TestCaseAttribute>().Select(test => (object?[])
            [.. test.Arguments.Zip(method.GetParameters(), static (value, parameter) => Convert.ChangeType(value, parameter.ParameterType, System.Globalization.CultureInfo.InvariantCulture))]);
    }

    private void CallAll(params Type[] attributes)
    {
        foreach (MethodInfo method in attributes.SelectMany(attribute => _fixture.GetType().GetMethods(Public).Where(method => method.IsDefined(attribute))))
            Call(method, []);
    }

    private void Call(MethodInfo method, object?[] arguments)
    {
        object? result;
        try
        {
            result = method.Invoke(_fixture, arguments);
        }
        catch (TargetInvocationException exception)
        {
            ExceptionDispatchInfo.Throw(exception.InnerException!);
            throw;
        }

        var running = new Stack<IEnumerator>();
        if (result is IEnumerator routine)
            running.Push(routine);

        // One step a frame. A step that is itself an enumerator runs to its end first.
        while (running.Count > 0)
        {
            if (!running.Peek().MoveNext())
                running.Pop();
            else if (running.Peek().Current is IEnumerator inner)
                running.Push(inner);
            else
                _loop.RunFor(0.002f);
        }
    }
}
