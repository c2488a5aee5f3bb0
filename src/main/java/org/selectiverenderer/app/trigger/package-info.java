/**
 * Trigger signals of sessions, such as to an EEG amplifier.
 *
 * <p>In: a study's {@link org.selectiverenderer.study.definition.TriggerSettings}, and the events
 * and signals of a session's journal. Out: bytes and wires of a serial port ({@link
 * org.selectiverenderer.tracker.serial.TriggerPort}), and an event {@code trigger} in the journal
 * for each. {@link org.selectiverenderer.app.trigger.TriggerSender} sends from the thread {@code
 * triggers}, so that no frame waits for a port.
 */
@NullMarked
package org.selectiverenderer.app.trigger;

import org.jspecify.annotations.NullMarked;
