/**
 * A study that runs at several sites: the sessions of several folders, put together.
 *
 * <p>In: a study and the folders of its sites, as sessions have left them. Out: a {@link
 * org.selectiverenderer.study.site.StudySites}, whose tables are those of {@code study.export} and
 * {@code study.session} with a column {@code site} and ids of participants that begin with the
 * site's name. Sessions of another version of the study, copies of sessions, and places of the
 * schedule that several sites gave away are reported. Nothing is written to any folder. Uses {@code
 * study.session}, {@code study.dataset} and {@code study.export}.
 */
@NullMarked
package org.selectiverenderer.study.site;

import org.jspecify.annotations.NullMarked;
