/**
 * Puts a study into a folder that any web server shows: a page that runs its sessions in a web
 * browser.
 *
 * <p>In: a study of module {@code study}, in all of its languages. Out: a {@link
 * org.selectiverenderer.export.study.StudyFolder}, the page of the folder {@code web}, the exported
 * scenes, and {@code study-web.json}, which tells the page what to show to the participant of each
 * place. Conditions, orders and trials are those that {@code study} plans; the page decides nothing.
 * Nothing is written here: the command does. What a browser cannot do is refused with its line in
 * the study file. Uses {@code export}, {@code study} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.export.study;

import org.jspecify.annotations.NullMarked;
