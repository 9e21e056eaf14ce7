using UnityEngine.Scripting;

// No other assembly refers to this one, so a build would leave it out.
[assembly: AlwaysLinkAssembly]
