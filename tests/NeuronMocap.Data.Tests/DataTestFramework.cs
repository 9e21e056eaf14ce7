using System.Reflection;
using Xunit.v3;

[assembly: TestFramework(typeof(NeuronMocap.Data.Tests.DataTestFramework))]

namespace NeuronMocap.Data.Tests;

/// <summary>
/// Finds these tests only if the folder shared/data exists. Otherwise it finds only <see cref="DataFolderTests"/>, which reports that the folder is
/// missing, and the tests that need no folder.
/// </summary>
public sealed class DataTestFramework : XunitTestFramework
{
    protected override ITestFrameworkDiscoverer CreateDiscoverer(Assembly assembly) => new Discoverer(new XunitTestAssembly(assembly));

    private sealed class Discoverer(IXunitTestAssembly assembly) : XunitTestFrameworkDiscoverer(assembly)
    {
        protected override Type[] GetExportedTypes() => Fixtures.Exists ? base.GetExportedTypes() : [typeof(DataFolderTests), typeof(Vendor.VendorFieldTests)];
    }
}
