/**
 * The Java binding of the X3D Scene Access Interface (ISO/IEC 19777-2): how a program outside of a
 * browser loads scenes, reads and writes fields, and hears of changes.
 *
 * <p>Names, signatures, constants and exceptions are those of Xj3D 2.3, the browser of the thesis,
 * so that a program compiled against this package runs on Xj3D with Xj3D's own copy in its place.
 * For that reason no type here has a method that Xj3D's lacks, apart from the standard's {@link
 * Browser#startRender()} with its two companions and {@link X3DExecutionContext#dispose()}; nothing
 * of the selective renderer is named, and the types come in a jar of their own. {@link
 * BrowserFactory} picks the browser. Uses nothing but the JDK and the nullness annotations, which
 * are not needed at run time.
 *
 * <h2>Nodes</h2>
 *
 * A browser hands out nodes as {@link X3DNode}; each also implements the interface of its type,
 * from this package for abstract types ({@link X3DGroupingNode}) and from the sub-package of its
 * component for concrete ones ({@link org.web3d.x3d.sai.grouping.Switch}), where there is one. Any
 * field of any node can be had from {@link X3DNode#getField}.
 *
 * <h2>How methods name fields</h2>
 *
 * The methods of node interfaces are named by field, so that one {@code java.lang.reflect.Proxy}
 * can serve all of them. Let {@code X} be a field's name with its first letter in upper case,
 * without a leading {@code set_} or a trailing {@code _changed} ({@code xDimension} gives {@code
 * XDimension}, {@code level_changed} gives {@code Level}, {@code set_bind} gives {@code Bind},
 * {@code isBound} gives {@code IsBound}):
 *
 * <ul>
 *   <li>{@code T getX()} reads a single value: {@code boolean, int, float, double, String}, or
 *       {@link X3DNode} for an SFNode, null when empty;
 *   <li>{@code void getX(T[] value)} reads a tuple or any number of values into the beginning of
 *       the array, tuples one after the other; an array that is too short gives an {@code
 *       ArrayIndexOutOfBoundsException};
 *   <li>{@code int getNumX()} is there for MF fields and tells their number of values: tuples where
 *       a value is a tuple;
 *   <li>{@code void setX(T value)} and {@code void setX(T[] value)} write; an array is taken whole
 *       by an MF field and by its first elements by a tuple; the overloads for an SFNode differ in
 *       the type of node only, and null empties the field;
 *   <li>{@code addChildren} and {@code removeChildren} write the fields of just these names.
 * </ul>
 *
 * A getter reads the field {@code x} that holds or sends a value, else {@code x_changed}. A setter
 * writes {@code x} if it is an inputOutput field, or an initializeOnly field of a node that is not
 * realized yet, else {@code set_x}; where there is none it throws {@link
 * InvalidOperationTimingException}. Method names that are not of this form are those of {@link
 * X3DNode} itself ({@code getNodeName, getFieldDefinitions, getNodeType, getField, realize,
 * isRealized, dispose}).
 *
 * <p>The interfaces are written by hand, though the rule and a table of nodes would give their
 * methods: each method says in words what its field means, in which unit and frame, which no table
 * knows, and whoever follows a call finds its source. A test holds them against the embedded
 * browser's table and lists where Xj3D differs.
 *
 * <p>The fields of many tuples ({@link MFColor}, {@link MFVec3f} ...) each declare the same methods
 * for callers by reflection: those of a shared type that is not the standard's, and so not public,
 * could not be invoked from other packages.
 *
 * <h2>Identity and names</h2>
 *
 * The SAI does not tell a node's DEF name; {@link X3DExecutionContext#getNamedNodes()} and {@link
 * X3DExecutionContext#getNamedNode} give the nodes of all names, to be compared with {@code
 * equals}: a browser may hand out one object per node (the embedded one does) or equal ones (Xj3D).
 *
 * <h2>Threads and time</h2>
 *
 * A browser decides when a write takes effect; the embedded one does at once, Xj3D at the next
 * frame, so that reading back may give the old value. Listeners are called within the event cascade
 * of a frame; what they write belongs to the same time stamp.
 */
@NullMarked
package org.web3d.x3d.sai;

import org.jspecify.annotations.NullMarked;
