/** A function of a text. */
export interface WgslFunction {
    readonly name: string;
    /** From `fn` to its closing bracket. */
    readonly text: string;
    /** Names of those that it calls. */
    readonly needs: readonly string[];
}
/** The functions of a text of the items, in order, each behind those that it calls: for hosts that take one at a time. No item
 *  is a shadow, which declares a block and a map, too. */
export function functions(items: readonly (Snippet | Bound)[]): WgslFunction[];
