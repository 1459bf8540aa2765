//! Drag and drop of a file onto a window, as a file manager does it (XDND version 5).

use std::path::Path;
use std::time::{Duration, Instant};

use x11rb::connection::Connection;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ClientMessageEvent, ConnectionExt as _, CreateWindowAux, EventMask, PropMode,
    SELECTION_NOTIFY_EVENT, SelectionNotifyEvent, Window, WindowClass,
};
use x11rb::wrapper::ConnectionExt as _;

use super::screen::Screen;

/// Drops `path` onto the middle of `target`; panics where the window does not take it.
pub fn drop_file(screen: &Screen, target: Window, path: &Path) {
    let connection = &screen.connection;
    let atom = |name: &str| connection.intern_atom(false, name.as_bytes()).unwrap().reply().unwrap().atom;
    let (uri_list, selection) = (atom("text/uri-list"), atom("XdndSelection"));
    let source = connection.generate_id().unwrap();
    let none = CreateWindowAux::new();
    connection.create_window(0, source, screen.root, 0, 0, 1, 1, 0, WindowClass::INPUT_ONLY, 0, &none).unwrap();
    connection.set_selection_owner(source, selection, x11rb::CURRENT_TIME).unwrap();

    let send = |kind: Atom, data: [u32; 4]| {
        let [a, b, c, d] = data;
        let message = ClientMessageEvent::new(32, target, kind, [source, a, b, c, d]);
        connection.send_event(false, target, EventMask::NO_EVENT, message).unwrap();
        connection.flush().unwrap();
    };
    let shape = connection.get_geometry(target).unwrap().reply().unwrap();
    let middle = u32::from(shape.width / 2) << 16 | u32::from(shape.height / 2);
    send(atom("XdndEnter"), [5 << 24, uri_list, 0, 0]);
    send(atom("XdndPosition"), [0, middle, 0, atom("XdndActionCopy")]);
    let content = format!("file://{}\r\n", path.display());
    let answer = |wanted: Atom, what: &str| {
        let until = Instant::now() + Duration::from_secs(60);
        while Instant::now() < until {
            match connection.poll_for_event().unwrap() {
                Some(Event::SelectionRequest(request)) => {
                    let place =
                        if request.property == u32::from(AtomEnum::NONE) { request.target } else { request.property };
                    connection
                        .change_property8(PropMode::REPLACE, request.requestor, place, uri_list, content.as_bytes())
                        .unwrap();
                    let told = SelectionNotifyEvent {
                        response_type: SELECTION_NOTIFY_EVENT,
                        sequence: 0,
                        time: request.time,
                        requestor: request.requestor,
                        selection: request.selection,
                        target: request.target,
                        property: place,
                    };
                    connection.send_event(false, request.requestor, EventMask::NO_EVENT, told).unwrap();
                    connection.flush().unwrap();
                }
                Some(Event::ClientMessage(message)) if message.type_ == wanted => return,
                Some(_) => {}
                None => std::thread::sleep(Duration::from_millis(10)),
            }
        }
        panic!("the window does not answer {what}");
    };
    answer(atom("XdndStatus"), "a file held over it");
    send(atom("XdndDrop"), [0, x11rb::CURRENT_TIME, 0, 0]);
    answer(atom("XdndFinished"), "a file dropped on it");
}
