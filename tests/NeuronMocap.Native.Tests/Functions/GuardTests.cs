using System.Reflection;
using System.Reflection.Emit;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Native.Host;

namespace NeuronMocap.Native.Tests.Functions;

// Every entry from C into the library, called here as C calls it. An exception inside becomes the function's failure and the last error. A function
// without a guard would end this process, or would not catch the exception that is meant for it.
public sealed class GuardTests
{
    private static readonly Exception[] Faults =
    [
        new InvalidOperationException("As meant."), new InsufficientMemoryException(), new InsufficientExecutionStackException(), new TypeInitializationException("Type", null),
        new ThreadInterruptedException(),
    ];

    private static readonly MethodInfo[] Entries =
    [
        .. typeof(Exports).Assembly.GetTypes()
            .SelectMany(static type => type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
            .Where(static method => method.IsDefined(typeof(UnmanagedCallersOnlyAttribute))),
    ];

    public static TheoryData<string> Names => new(Entries.Select(static method => method.Name));

    [Fact]
    public void Every_function_is_guarded() => Assert.InRange(Entries.Length, 23, 100);

    [Theory]
    [MemberData(nameof(Names))]
    public void A_fault_fails_the_function_and_sets_the_last_error(string name)
    {
        MethodInfo entry = Entries.Single(method => method.Name == name);
        foreach (Exception fault in Faults)
        {
            LastError.Set("No error.");
            ExportGuard.Fault = fault;

            object? result = Call(entry);
            Exception? left = ExportGuard.Fault;
            ExportGuard.Fault = null;

            Assert.Null(left);
            Assert.Equal(FailureOf(entry), result);
            string text = Marshal.PtrToStringUTF8(LastError.Pointer)!;
            if (fault is OutOfMemoryException)
                Assert.Contains("memory", text, StringComparison.Ordinal);
            else
                Assert.StartsWith($"{name} failed because of an error in the library: {fault.GetType()}", text, StringComparison.Ordinal);
        }
    }

    private static object? FailureOf(MethodInfo entry) => entry.Name switch
    {
        nameof(Exports.BRGetSocketStatus) => 2,
        nameof(Exports.BRGetLastErrorMessage) => ExportGuard.NoMemory,
        _ => entry.ReturnType == typeof(void) ? null : Activator.CreateInstance(entry.ReturnType),
    };

    // Called with zeros and null pointers, by the address that C has.
    private static object? Call(MethodInfo entry)
    {
        CallingConvention convention = entry.GetCustomAttribute<UnmanagedCallersOnlyAttribute>()!.CallConvs is { Length: > 0 } ? CallingConvention.Cdecl : CallingConvention.Winapi;
        Type[] types = [.. entry.GetParameters().Select(static parameter => parameter.ParameterType)];
        var caller = new DynamicMethod(entry.Name, typeof(object), [typeof(IntPtr)], typeof(GuardTests).Module, skipVisibility: true);
        ILGenerator code = caller.GetILGenerator();
        foreach (Type type in types)
        {
            code.Emit(OpCodes.Ldc_I4_0);
            if (type != typeof(int))
                code.Emit(OpCodes.Conv_I);
        }

        code.Emit(OpCodes.Ldarg_0);
        code.EmitCalli(OpCodes.Calli, convention, entry.ReturnType, types);
        if (entry.ReturnType == typeof(void))
            code.Emit(OpCodes.Ldnull);
        else
            code.Emit(OpCodes.Box, entry.ReturnType);
        code.Emit(OpCodes.Ret);
        return caller.CreateDelegate<Func<IntPtr, object?>>()(entry.MethodHandle.GetFunctionPointer());
    }
}
