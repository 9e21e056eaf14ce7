import { connection } from "./live/program";

// The program answers while the browser reads and compiles the rest of the page.
connection.connect();
void import("./main");
