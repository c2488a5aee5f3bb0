/**
 * The enricher's 3D preview: the document as our own runtime shows it, picked, outlined, as if in
 * schemas, walked; and small pictures of versions.
 *
 * <p>The preview steps a {@code World} and draws it with the renderer of {@code run}, offscreen,
 * and a Swing component shows the picture: no heavyweight component, no OpenGL on the event
 * dispatch thread, the same in a test without a window manager. Every picture's alpha is the mask
 * of what is selected, of which the outline is made. "As if in" asks {@link
 * org.selectiverenderer.schema.Activation}; walking puts the controller itself in charge, as {@code
 * run} does; the scene is never switched by code of this package's own. A click is a ray; the node
 * that it hits is found in the document by its DEF name, or by its place in the text if that is
 * still the text that was loaded.
 *
 * <p>An edit that only changes what may change in a running scene is a {@code ScenePatch}, found by
 * {@code TextComparison} from the two texts on the loader's thread and sent as events on the
 * preview's thread; where one of its nodes is not there, all is loaded instead.
 *
 * <p>Comparing draws the same scene again with every object at its most detailed, and puts it back
 * as it was; {@code enricher.compare} says how both pictures share the component. {@code
 * VersionChoice} shows one object in another version.
 *
 * <p>In: snapshots of a document, the selection, the author's mouse and keys. Out: pictures in a
 * Swing component; the object that was clicked. {@code PreviewPanel} and everything of Swing
 * belongs to the event dispatch thread; the running scene and GL to one thread of {@code
 * PreviewThread}, which is told what to do and answers with {@code PreviewFrame}s; files are read
 * by {@code SceneFeed}'s thread.
 *
 * <p>Uses {@code enricher.parts}, {@code enricher.session}, {@code enricher.compare}, {@code
 * document}, {@code app.walk}, {@code control}, {@code runtime} with its renderer but not JOGL,
 * {@code schema}, {@code geometry}, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.preview;

import org.jspecify.annotations.NullMarked;
