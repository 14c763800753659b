/** The two things about an Inline that X3D gives no field for, as X_ITE 15.0.1 tells them. */
const kNotStarted = 1006, kInProgress = 1007, kComplete = 1008;

/** 'absent', 'loading', 'live' or 'failed'. */
export function inlinePhase(inline) {
    if (!inline.load) return 'absent';
    const state = inline.getValue().checkLoadState();
    if (state === kNotStarted || state === kInProgress) return 'loading';
    return state === kComplete ? 'live' : 'failed';
}

/** The scene inside a live Inline: has getNamedNode() and rootNodes. */
export function inlineScene(inline) {
    return inline.getValue().getInternalScene();
}
