/**
 * The selective rendering controller (thesis 4.3, Figs 48 and 49), which selects the version of
 * each object as the viewer enters and leaves areas.
 *
 * <p>It accesses a browser through {@code org.web3d.x3d.sai} only, so that it runs unchanged on
 * Xj3D, the browser of the thesis. The standard's {@code BrowserFactory} chooses the browser; ours
 * is the default. The build puts the SAI's interfaces into a jar of their own, so that another
 * browser's copy can replace them on the class path.
 *
 * <p>In: a browser. Out: {@code whichChoice} of Switch nodes, fields that are qualities of objects,
 * and {@link org.selectiverenderer.control.ControlEvent}s. Of {@code schema} it uses the vocabulary
 * of the metadata and {@link org.selectiverenderer.schema.SchemaActivation}, the algorithm without
 * a browser: an index from schemas to Switches, so that activation costs what it changes. Under a
 * budget ({@code control.budget}) areas tell only how consistent objects are, and whoever keeps the
 * budget chooses by {@link org.selectiverenderer.control.SelectiveController#choose}. Uses {@code
 * schema}, {@code org.web3d.x3d.sai}, and {@code sai} for what a browser may offer beyond it; loads
 * no AWT and no GL.
 *
 * <p>{@code SceneController} follows a scene: it finds areas and objects and listens to them.
 * {@code SceneChoices} decides what the objects show; what may not be shown yet waits in {@code
 * ChoiceQueue}.
 *
 * <p>A street of copies of one file has tens of thousands of objects. So metadata are read once by
 * each object, what identical metadata say is found once ({@code SchemaCache}), and a browser that
 * tells the names of nodes is asked for those of areas and objects alone.
 */
@NullMarked
package org.selectiverenderer.control;

import org.jspecify.annotations.NullMarked;
