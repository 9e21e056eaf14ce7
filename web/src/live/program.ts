import { Api } from "../page/api";
import { Connection } from "./connection";

/** The program that serves the page. */
export const api = new Api();
export const connection = new Connection(api);
