/**
 * The enricher's 3D preview: shows the document with our own runtime, with picking, outlines,
 * simulated schemas and live walks; and renders small pictures of versions.
 *
 * <p>The preview steps a {@code World}, renders it offscreen with the renderer of {@code run}, and
 * a Swing component shows the picture: so there is no heavyweight component, no OpenGL on the event
 * dispatch thread, and no difference in a test without a window manager. Each picture's alpha
 * channel is the mask of the selection, from which the outline is made. "As if in" asks {@link
 * org.selectiverenderer.schema.SchemaActivation}; a walk runs the controller itself, as {@code run}
 * does; no code of this package decides what a Switch shows. A click casts a ray; the node that it
 * hits is found in the document by its DEF name, or by its position in the text if that is still
 * the text that was loaded.
 *
 * <p>An edit that only changes what may change in a running scene becomes a {@code ScenePatch}:
 * {@code SceneTextDiff} finds it on the loader's thread, from the {@code ChangedPart} that holds
 * all that has changed or, where that does not tell enough, from the two texts, and it is sent as
 * events on the preview's thread; where one of its nodes is missing, the document is loaded
 * instead.
 *
 * <p>A comparison renders the same scene again with every object at its most detailed, and then
 * restores it; {@code enricher.compare} lays out both pictures in the component. {@code
 * VersionOverride} shows one object in another version.
 *
 * <p>{@code ObjectHandles} move, turn and scale the selected objects: a drag changes the running
 * scene only, its end is one edit by {@code enricher.placement}. {@code ObjectQueries} measures
 * objects for them and for the plan, {@code StoreyFinder} and {@code PlanShapes} say where a plan
 * is cut and what it leaves out.
 *
 * <p>In: snapshots of a document, the selection, the author's mouse and keys. Out: pictures in a
 * Swing component; the object that was clicked. {@code PreviewPanel} and everything of Swing
 * belongs to the event dispatch thread; the running scene and GL to one thread of {@code
 * PreviewThread}, which is told what to do and answers with {@code PreviewFrame}s; files are read
 * by {@code PreviewUpdater}'s thread.
 *
 * <p>Uses {@code enricher.component}, {@code enricher.session}, {@code enricher.compare}, {@code
 * authoring}, {@code walkthrough}, {@code control}, {@code browser} with its renderer but not JOGL,
 * {@code schema}, {@code geometry}, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.enricher.preview;

import org.jspecify.annotations.NullMarked;
