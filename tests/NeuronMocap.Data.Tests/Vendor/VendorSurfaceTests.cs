using System.Reflection;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;

namespace NeuronMocap.Data.Tests.Vendor;

/// <summary>
/// Compares both namespaces with the tables of the vendor's wrappers. Both must have everything that any of the three generations has.
/// </summary>
public sealed partial class VendorSurfaceTests
{
    private static readonly Assembly Library = typeof(NeuronMocap.Compatibility.CompatibilityEvents).Assembly;

    private static readonly Dictionary<string, Type> Keywords = new(StringComparer.Ordinal)
    {
        ["void"] = typeof(void),
        ["bool"] = typeof(bool),
        ["int"] = typeof(int),
        ["uint"] = typeof(uint),
        ["UInt32"] = typeof(uint),
        ["ushort"] = typeof(ushort),
        ["byte"] = typeof(byte),
        ["byte[]"] = typeof(byte[]),
        ["float"] = typeof(float),
        ["string"] = typeof(string),
        ["IntPtr"] = typeof(IntPtr),
    };

    public static TheoryData<string> Namespaces => ["NeuronDataReaderWraper", "NeuronDataReaderManaged"];

    [Theory, MemberData(nameof(Namespaces))]
    public void Enums_have_the_vendors_names_and_numbers(string space)
    {
        List<string[]> rows = [.. VendorTables.Require().TypesOf("enum")];
        Assert.Equal(3, rows.Count);
        foreach (string[] row in rows)
        {
            IReadOnlyList<string> code = VendorTables.Code(row[0]);
            Type type = Find(space, code[0]);
            Assert.Equal(typeof(int), Enum.GetUnderlyingType(type));
            for (int number = 1; number < code.Count; number++)
                Assert.Equal(number - 1, Convert.ToInt32(Enum.Parse(type, code[number]), System.Globalization.CultureInfo.InvariantCulture));
        }
    }

    [Theory, MemberData(nameof(Namespaces))]
    public void Structs_have_the_vendors_fields_and_offsets(string space)
    {
        List<string[]> rows = [.. VendorTables.Require().TypesOf("struct")];
        Assert.Equal(["DataVersion", "BvhDataHeader", "CalcDataHeader", "CommandPack", "CmdResponseBoneSize"], rows.Select(static row => VendorTables.Code(row[0])[0]));
        foreach (string[] row in rows)
        {
            Type type = Find(space, VendorTables.Code(row[0])[0]);
            StructLayoutAttribute layout = Assert.IsType<StructLayoutAttribute>(type.StructLayoutAttribute);
            Assert.Equal((LayoutKind.Sequential, 1), (layout.Value, layout.Pack));
            AssertLayout(space, type, FieldsOf(row));
            if (row[0].Contains("64 bytes", StringComparison.Ordinal))
                Assert.Equal(64, Marshal.SizeOf(type));
        }
    }

    // Their layout belongs to the older stream, which never reaches scripts. They only have to compile.
    [Theory, MemberData(nameof(Namespaces))]
    public void Names_of_the_older_header_compile(string space)
    {
        string[] row = VendorTables.Require().TypesOf("struct").Single(static row => row[0].Contains("BvhDataHeader", StringComparison.Ordinal));
        IReadOnlyList<VendorField> fields = VendorField.Parse(row[1]);
        Assert.Equal(10, fields.Count);
        Type type = Find(space, "BvhDataHeader");
        foreach (VendorField field in fields)
        {
            Type actual = type.GetField(field.Name)?.FieldType ?? Assert.IsType<PropertyInfo>(type.GetProperty(field.Name), exactMatch: false).PropertyType;
            Assert.True(Converts(actual, TypeOf(space, field.Type)), $"{field.Name} is {actual}, not {field.Type}.");
        }
    }

    [Theory, MemberData(nameof(Namespaces))]
    public void Delegates_have_the_vendors_parameters_and_calling_convention(string space)
    {
        List<string[]> rows = [.. VendorTables.Require().TypesOf("delegate")];
        Assert.Equal(3, rows.Count);
        foreach (string[] row in rows)
        {
            Match match = Signature().Match("void " + VendorTables.Code(row[0])[0]);
            Type type = Find(space, match.Groups["name"].Value);
            AssertSignature(space, match, type.GetMethod("Invoke")!);
            CallingConvention? convention = type.GetCustomAttribute<UnmanagedFunctionPointerAttribute>()?.CallingConvention;
            Assert.Equal(space == "NeuronDataReaderWraper" ? CallingConvention.StdCall : null, convention);
        }

        Assert.Contains("StdCall attribute in W1/W2", rows[0][0], StringComparison.Ordinal);
        Assert.EndsWith("no attribute", rows[0][3], StringComparison.Ordinal);
    }

    [Theory, MemberData(nameof(Namespaces))]
    public void The_class_has_the_vendors_methods_and_fields(string space)
    {
        Type type = Find(space, "NeuronDataReader");
        Assert.True(type is { IsClass: true, IsPublic: true, IsAbstract: false, IsSealed: false });

        int methods = 0;
        int fields = 0;
        foreach (string code in VendorTables.Require().Methods.SelectMany(static row => VendorTables.Code(row[0])))
        {
            Match match = Signature().Match(code);
            if (match.Success)
            {
                methods++;
                AssertSignature(space, match, Assert.IsType<MethodInfo>(type.GetMethod(match.Groups["name"].Value), exactMatch: false));
            }
            else
            {
                fields++;
                FieldInfo field = Assert.IsType<FieldInfo>(type.GetField(code), exactMatch: false);
                Assert.True(field is { IsStatic: true, IsPublic: true, IsInitOnly: false });
            }
        }

        Assert.Equal((14, 2), (methods, fields));
    }

    // The only row of unknown shape.
    [Fact]
    public void The_table_of_types_is_complete()
    {
        IEnumerable<string> others = VendorTables.Require().Types.Select(static row => row[0])
            .Where(static text => !text.StartsWith("enum ", StringComparison.Ordinal)
                && !text.StartsWith("struct ", StringComparison.Ordinal)
                && !text.StartsWith("delegate ", StringComparison.Ordinal));
        Assert.StartsWith("`OptDataReceived`", Assert.Single(others), StringComparison.Ordinal);
    }

    private static IReadOnlyList<VendorField> FieldsOf(string[] row)
    {
        // Where generations differ, b15 applies. Otherwise the fields are in the cell of the name.
        if (row[2].Contains('`', StringComparison.Ordinal))
            return VendorField.Parse(row[2]);

        string own = row[0].Contains('{', StringComparison.Ordinal) ? row[0].Split('{')[1] : row[0].Split(':', 2)[1];
        return VendorField.Parse(own);
    }

    private static void AssertLayout(string space, Type type, IReadOnlyList<VendorField> expected)
    {
        FieldInfo[] actual = [.. type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).OrderBy(static field => field.MetadataToken)];
        Assert.Equal(expected.Select(static field => field.Name), actual.Select(static field => field.Name));
        int offset = 0;
        foreach ((VendorField field, FieldInfo own) in expected.Zip(actual))
        {
            Assert.True(own.IsPublic);
            Assert.Equal(TypeOf(space, field.Type), own.FieldType);
            Assert.Equal(offset, (int)Marshal.OffsetOf(type, field.Name));
            MarshalAsAttribute? marshal = own.GetCustomAttribute<MarshalAsAttribute>();
            Assert.Equal(field.Size, marshal?.SizeConst);
            if (marshal is not null)
                Assert.Equal(own.FieldType == typeof(string) ? UnmanagedType.ByValTStr : UnmanagedType.ByValArray, marshal.Value);

            offset += field.Bytes;
        }

        Assert.Equal(offset, Marshal.SizeOf(type));
    }

    private static void AssertSignature(string space, Match expected, MethodInfo actual)
    {
        Assert.Equal(TypeOf(space, expected.Groups["type"].Value), actual.ReturnType);
        string[] parameters = expected.Groups["parameters"].Value.Split(", ", StringSplitOptions.RemoveEmptyEntries);
        ParameterInfo[] own = actual.GetParameters();
        Assert.Equal(parameters.Length, own.Length);
        foreach ((string text, ParameterInfo parameter) in parameters.Zip(own))
        {
            string[] words = text.Split(' ');
            bool isText = words[0] == "[LPStr]";
            Assert.Equal(isText ? UnmanagedType.LPStr : null, parameter.GetCustomAttribute<MarshalAsAttribute>()?.Value);
            string[] rest = isText ? words[1..] : words;
            Assert.Equal(TypeOf(space, rest[0]), parameter.ParameterType);
            if (rest.Length > 1)
                Assert.Equal(rest[1], parameter.Name);
        }
    }

    private static bool Converts(Type from, Type to) =>
        from == to || (to == typeof(uint) && (from == typeof(ushort) || from == typeof(byte)));

    private static Type TypeOf(string space, string name) => Keywords.TryGetValue(name, out Type? type) ? type : Find(space, name);

    private static Type Find(string space, string name) =>
        Library.GetType($"{space}.{name}") ?? throw new InvalidOperationException($"{space} has no {name}.");

    [GeneratedRegex(@"^(?<type>\S+) (?<name>\w+)\((?<parameters>.*)\)$", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Signature();
}
