/**
 * A run's or a session's part in the Lab Streaming Layer.
 *
 * <p>Out, by {@link org.selectiverenderer.app.stream.StreamSender}: three streams, of poses (each
 * frame), of what is looked at (each change) and of events. In, by {@link
 * org.selectiverenderer.app.stream.StreamRecorder}: streams of other programs, written beside the
 * head logs with the offsets of their clocks.
 *
 * <pre>
 *   stepping thread -- samples --> queue -> thread lsl-out -> outlets -> network
 *   journal, time line -- events -^
 *   network -> inlets -> thread lsl-in -> streams/NAME_run-NN.csv, .offsets.csv, .json
 * </pre>
 *
 * <p>The two threads are the only ones that call the library; nobody waits for them but the end of
 * the session. {@link org.selectiverenderer.app.stream.LabStreams} owns both. Uses {@code lsl},
 * {@code app.head} for the samples, {@code app.timeline}, {@code experiment.headlog} and {@code
 * base}.
 */
@NullMarked
package org.selectiverenderer.app.stream;

import org.jspecify.annotations.NullMarked;
