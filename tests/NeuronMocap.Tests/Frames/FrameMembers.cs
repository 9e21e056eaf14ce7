using System.Reflection;
using System.Reflection.Emit;

namespace NeuronMocap.Tests.Frames;

/// <summary>
/// Every public member of a frame that reads it, found by reflection, as a delegate. The delegates use generated code, because reflection cannot pass
/// spans.
/// </summary>
internal static class FrameMembers
{
    public static IReadOnlyList<(string Name, Action<AvatarFrame> Read)> Of(Type type) =>
    [
        .. type.GetMethods(BindingFlags.Public | BindingFlags.Instance)
            .Where(static method => method.GetBaseDefinition().DeclaringType != typeof(object))
            .Select(static method => (method.ToString()!, Compile(method))),
    ];

    private static Action<AvatarFrame> Compile(MethodInfo method)
    {
        var call = new DynamicMethod($"Call_{method.Name}", typeof(void), [typeof(AvatarFrame)], typeof(FrameMembers).Module, skipVisibility: true);
        ILGenerator il = call.GetILGenerator();
        il.Emit(OpCodes.Ldarg_0);
        foreach (ParameterInfo parameter in method.GetParameters())
            LoadArgument(il, parameter.ParameterType);

        il.Emit(OpCodes.Callvirt, method);
        if (method.ReturnType != typeof(void))
            il.Emit(OpCodes.Pop);

        il.Emit(OpCodes.Ret);
        return call.CreateDelegate<Action<AvatarFrame>>();
    }

    // Spans have room for all bones, and other arguments are default values. A null body is not examined before the frame is.
    private static void LoadArgument(ILGenerator il, Type type)
    {
        if (type.IsGenericType && type.GetGenericTypeDefinition() == typeof(Span<>))
        {
            il.Emit(OpCodes.Ldc_I4, 59);
            il.Emit(OpCodes.Newarr, type.GenericTypeArguments[0]);
            il.Emit(OpCodes.Newobj, type.GetConstructor([type.GenericTypeArguments[0].MakeArrayType()])!);
            return;
        }

        LocalBuilder value = il.DeclareLocal(type);
        il.Emit(OpCodes.Ldloca, value);
        il.Emit(OpCodes.Initobj, type);
        il.Emit(OpCodes.Ldloc, value);
    }
}
