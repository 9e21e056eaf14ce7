// A window that shows live motion: the status in words, the avatars, a skeleton from the front and the side, rates, and a button that records.
//
//   dotnet run --project samples/DesktopForms -f net10.0-windows                   Windows, .NET
//   dotnet run --project samples/DesktopForms -f net472                            Windows, .NET Framework
//   mono samples/DesktopForms/bin/Release/net472/DesktopForms.exe                    Linux, after dotnet build
//
// An address as the argument, for example 192.168.1.20, connects immediately. The address demo is a simulator inside this program.
// In your own project: dotnet add package NeuronMocap (and NeuronMocap.Server for the simulator).
using System;
using System.Windows.Forms;

internal static class Program
{
    [STAThread]
    private static void Main(string[] arguments)
    {
        ApplicationConfiguration.Initialize();
        Application.Run(new MainWindow(arguments.Length > 0 ? arguments[0] : null));
    }
}
